#include <fmt/format.h>

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "scenes/mesh_file.hpp"
#include "scenes/mesh_normals.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/number_text.hpp"

namespace twofold {
namespace {

constexpr std::size_t max_obj_bytes = std::size_t{1} << 30;

/// Coordinates beyond this are refused: their squares must stay finite in the arithmetic of
/// normals.
constexpr double max_coordinate = 1e30;

/// Positions in the lists of v, vt and vn, from 0; -1 where a corner names none.
using Corner = std::array<int, 3>;

/// The lists of the file, faces already cut into triangles (three corners each).
struct ObjContent {
    std::vector<Vec3> positions;
    std::vector<Vec4> colors;  ///< white where a line has none
    bool has_colors = false;
    std::vector<Vec4> texcoords;
    std::vector<Vec3> normals;
    std::vector<Corner> corners;
};

/// Reads line by line; every error names file and line.
class ObjParser {
  public:
    explicit ObjParser(std::string name) : name_(std::move(name)) {}

    ObjContent parse(std::string_view text) {
        while (!text.empty()) {
            ++line_;
            statement(take_line(text));
        }
        check_forward_references();
        return std::move(content_);
    }

  private:
    static constexpr std::array<const char*, 3> lists{"v", "vt", "vn"};

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(ExitCode::bad_file, fmt::format("{}:{}: {}", name_, line_, what));
    }

    void statement(std::string_view line) {
        const std::string_view keyword = take_word(line);
        if (keyword == "v") position(line);
        if (keyword == "vt") texcoord(line);
        if (keyword == "vn") normal(line);
        if (keyword == "f") face(line);
    }

    /// The words up to the end of the line or a comment.
    std::vector<std::string_view> words(std::string_view line) const {
        std::vector<std::string_view> result;
        for (auto word = take_word(line); !word.empty() && word[0] != '#'; word = take_word(line))
            result.push_back(word);
        return result;
    }

    std::vector<double> numbers(std::string_view line, std::size_t least, std::size_t most) const {
        std::vector<double> result;
        for (const std::string_view word : words(line)) {
            const auto value = parse_real(word);
            if (!value) fail(fmt::format("'{}' is not a number", printable(word, 40)));
            if (!(*value >= -max_coordinate && *value <= max_coordinate))
                fail(fmt::format("{} is out of range", printable(word, 40)));
            result.push_back(*value);
        }
        if (result.size() < least || result.size() > most)
            fail(fmt::format("{} numbers where {} to {} are expected", result.size(), least, most));
        return result;
    }

    void check_count(std::size_t count) const {
        if (count >= max_mesh_vertices)
            fail(fmt::format("more than {} vertices", max_mesh_vertices));
    }

    void position(std::string_view line) {
        const auto n = numbers(line, 3, 6);
        if (n.size() == 5) fail("5 numbers where x y z, x y z w or x y z r g b are expected");
        check_count(content_.positions.size());
        content_.positions.emplace_back(n[0], n[1], n[2]);
        const bool colored = n.size() == 6;
        const Vec4 color = colored ? Vec4(n[3], n[4], n[5], 1.0) : Vec4(1.0);
        for (int c = 0; c < 3; ++c)
            if (color[c] < 0.0 || color[c] > 1.0) fail("a colour outside 0 to 1");
        content_.colors.push_back(color);
        content_.has_colors = content_.has_colors || colored;
    }

    void texcoord(std::string_view line) {
        const auto n = numbers(line, 1, 3);
        check_count(content_.texcoords.size());
        content_.texcoords.emplace_back(n[0], n.size() > 1 ? n[1] : 0.0, n.size() > 2 ? n[2] : 0.0,
                                        1.0);
    }

    void normal(std::string_view line) {
        const auto n = numbers(line, 3, 3);
        check_count(content_.normals.size());
        content_.normals.emplace_back(n[0], n[1], n[2]);
    }

    void face(std::string_view line) {
        const auto corner_words = words(line);
        if (corner_words.size() < 3)
            fail(fmt::format("a face of {} corners, at least 3 are needed", corner_words.size()));
        if (content_.corners.size() / 3 + corner_words.size() - 2 > max_mesh_triangles)
            fail(fmt::format("more than {} triangles", max_mesh_triangles));
        const Corner first = corner(corner_words[0]);
        Corner previous = corner(corner_words[1]);
        for (std::size_t i = 2; i < corner_words.size(); ++i) {
            const Corner next = corner(corner_words[i]);
            content_.corners.insert(content_.corners.end(), {first, previous, next});
            previous = next;
        }
    }

    /// v, v/vt, v//vn or v/vt/vn.
    Corner corner(std::string_view word) {
        Corner result{-1, -1, -1};
        const std::string_view whole = word;
        for (std::size_t list = 0; list < 3; ++list) {
            const std::size_t end = std::min(word.find('/'), word.size());
            const std::string_view digits = word.substr(0, end);
            if (!digits.empty()) result[list] = index(digits, list);
            if (end == word.size()) break;
            word.remove_prefix(end + 1);
            if (list == 2 || (word.empty())) malformed(whole);
        }
        if (result[0] < 0) malformed(whole);
        return result;
    }

    [[noreturn]] void malformed(std::string_view word) const {
        fail(
            fmt::format("'{}' is not a corner such as 1, 1/2, 1//3 or 1/2/3", printable(word, 40)));
    }

    /// Counts from 1, or backwards from the end of the list so far. A positive index may name a
    /// line that is still to come, so only the greatest is kept and checked at the end.
    int index(std::string_view digits, std::size_t list) {
        const auto value = parse_integer(digits);
        if (!value) fail(fmt::format("'{}' is not an index", printable(digits, 40)));
        const auto size = static_cast<long long>(list_size(list));
        if (*value == 0 || *value < -size || *value > static_cast<long long>(max_mesh_vertices))
            out_of_range(*value, list);
        if (*value < 0) return static_cast<int>(size + *value);
        if (*value > greatest_[list].value) greatest_[list] = {*value, line_};
        return static_cast<int>(*value - 1);
    }

    [[noreturn]] void out_of_range(long long value, std::size_t list) const {
        fail(fmt::format("index {} into a list of {} '{}' lines", value, list_size(list),
                         lists[list]));
    }

    void check_forward_references() {
        for (std::size_t list = 0; list < 3; ++list) {
            if (greatest_[list].value <= static_cast<long long>(list_size(list))) continue;
            line_ = greatest_[list].line;
            out_of_range(greatest_[list].value, list);
        }
    }

    std::size_t list_size(std::size_t list) const {
        return std::array{content_.positions.size(), content_.texcoords.size(),
                          content_.normals.size()}[list];
    }

    struct Reference {
        long long value = 0;
        std::size_t line = 0;
    };

    std::string name_;
    std::size_t line_ = 0;
    ObjContent content_;
    std::array<Reference, 3> greatest_;
};

/// Normals for the positions of corners that name none; empty if every corner names a usable one.
std::vector<Vec3> computed_normals(const ObjContent& content) {
    std::vector<std::uint32_t> indices;
    indices.reserve(content.corners.size());
    bool missing = false;
    for (const Corner& corner : content.corners) {
        indices.push_back(static_cast<std::uint32_t>(corner[0]));
        missing = missing || corner[2] < 0;
    }
    return missing ? vertex_normals(content.positions, indices) : std::vector<Vec3>();
}

/// A zero vector is no normal, so its corners count as naming none.
void drop_zero_normals(ObjContent& content) {
    for (Corner& corner : content.corners) {
        if (corner[2] < 0) continue;
        if (!has_direction(content.normals[static_cast<std::size_t>(corner[2])])) corner[2] = -1;
    }
}

void append_vertex(Mesh& mesh, const ObjContent& content, const std::vector<Vec3>& computed,
                   const Corner& corner) {
    const auto v = static_cast<std::size_t>(corner[0]);
    mesh.positions.push_back(content.positions[v]);
    mesh.normals.push_back(corner[2] < 0
                               ? computed[v]
                               : normalized(content.normals[static_cast<std::size_t>(corner[2])]));
    if (content.has_colors) mesh.colors.push_back(content.colors[v]);
    if (!content.texcoords.empty())
        mesh.texcoords[0].push_back(corner[1] < 0
                                        ? Vec4(0.0, 0.0, 0.0, 1.0)
                                        : content.texcoords[static_cast<std::size_t>(corner[1])]);
}

Mesh build_mesh(const ObjContent& content, const std::string& name) {
    const std::vector<Vec3> computed = computed_normals(content);
    Mesh mesh;
    std::map<Corner, std::uint32_t> vertex_of;
    for (const Corner& corner : content.corners) {
        const auto next = static_cast<std::uint32_t>(mesh.positions.size());
        const auto [entry, added] = vertex_of.emplace(corner, next);
        if (added && next == max_mesh_vertices)
            throw Error(ExitCode::bad_file,
                        fmt::format("{}: more than {} vertices after its corners are told apart",
                                    name, max_mesh_vertices));
        if (added) append_vertex(mesh, content, computed, corner);
        mesh.indices.push_back(entry->second);
    }
    return mesh;
}

}  // namespace

Mesh parse_obj(std::string_view text, const std::string& name) {
    if (is_git_lfs_pointer({reinterpret_cast<const unsigned char*>(text.data()), text.size()}))
        throw Error(ExitCode::bad_file, name +
                                            ": a Git LFS pointer instead of the mesh; fetch it "
                                            "with 'git lfs pull'");
    ObjContent content = ObjParser(name).parse(text);
    if (content.corners.empty()) throw Error(ExitCode::bad_file, name + ": no faces");
    drop_zero_normals(content);
    return build_mesh(content, name);
}

Mesh read_obj(const std::filesystem::path& path) {
    return parse_obj(read_text_file(path, max_obj_bytes), path.string());
}

}  // namespace twofold
