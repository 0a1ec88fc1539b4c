#include <fmt/format.h>

#include <charconv>
#include <map>
#include <sstream>

#include "bench/draw/inputs.hpp"
#include "bench/draw/raw_array.hpp"
#include "texunit/error.hpp"

namespace twofold::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_manifest_bytes = 1 << 16;
constexpr int max_vertices = 4'000'000, max_edge = 4096;

/// The lines of the manifest: a name and its words.
class Manifest {
  public:
    explicit Manifest(const fs::path& folder) : file_((folder / "manifest.txt").string()) {
        std::istringstream text(read_text_file(file_, max_manifest_bytes));
        for (std::string line; std::getline(text, line);) {
            std::istringstream words(line);
            std::string name, word;
            if (!(words >> name) || name.starts_with('#')) continue;
            for (auto& list = fields_[name]; words >> word;) list.push_back(word);
        }
    }

    const std::vector<std::string>& words(const std::string& name, std::size_t count) const {
        const auto field = fields_.find(name);
        if (field == fields_.end()) fail(name, "is missing");
        if (field->second.size() != count)
            fail(name, fmt::format("has {} values, not {}", field->second.size(), count));
        return field->second;
    }

    int integer(const std::string& name, std::size_t count, int high) const {
        const std::string& word = words(name, count).front();
        int value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size() || value < 1 || value > high)
            fail(name, fmt::format("{} is not a number from 1 to {}", word, high));
        return value;
    }

    /// An edge of a square.
    int edge(const std::string& name) const {
        const auto& both = words(name, 2);
        if (both[0] != both[1]) fail(name, fmt::format("{} x {} is no square", both[0], both[1]));
        return integer(name, 2, max_edge);
    }

    Mat4 matrix(const std::string& name) const {
        const auto& numbers = words(name, 16);
        Mat4 m{};
        for (std::size_t i = 0; i < 16; ++i)
            m[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = real(name, numbers[i]);
        return m;
    }

    /// What drawing.hpp draws with, whatever the manifest says, so it has to say the same.
    void require(const std::string& name, const std::vector<std::string>& wanted) const {
        const auto& found = words(name, wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (found[i] != wanted[i]) fail(name, fmt::format("{} is not {}", found[i], wanted[i]));
    }

  private:
    [[noreturn]] void fail(const std::string& name, const std::string& text) const {
        throw Error(ExitCode::bad_file, fmt::format("{}: {}: {}", file_, name, text));
    }

    /// A hexadecimal number as printf's %a writes it.
    double real(const std::string& name, const std::string& word) const {
        std::string_view digits = word;
        const bool negative = digits.starts_with('-');
        if (negative) digits.remove_prefix(1);
        double value = 0.0;
        if (!digits.starts_with("0x")) fail(name, word + " is not a hexadecimal number");
        digits.remove_prefix(2);
        const char* last = digits.data() + digits.size();
        const auto [end, error] =
            std::from_chars(digits.data(), last, value, std::chars_format::hex);
        if (error != std::errc{} || end != last) fail(name, word + " is not a hexadecimal number");
        return negative ? -value : value;
    }

    std::string file_;
    std::map<std::string, std::vector<std::string>> fields_;
};

template <class Element, class Convert>
auto read_converted(const fs::path& file, std::size_t count, Convert convert) {
    std::vector<decltype(convert(Element{}))> result;
    result.reserve(count);
    for (const Element& e : read_array<Element>(file, count)) result.push_back(convert(e));
    return result;
}

Mesh read_mesh(const fs::path& folder, std::size_t vertices, std::size_t triangles) {
    using Float2 = std::array<float, 2>;
    using Float3 = std::array<float, 3>;
    const auto vec3 = [](const Float3& v) { return Vec3{v[0], v[1], v[2]}; };
    const auto st = [](const Float2& v) { return Vec4{v[0], v[1], 0.0, 1.0}; };
    const auto color = [](Rgba8 c) { return Vec4{c.r, c.g, c.b, c.a} / 255.0; };
    Mesh mesh;
    mesh.positions = read_converted<Float3>(folder / "position.f32x3", vertices, vec3);
    mesh.normals = read_converted<Float3>(folder / "normal.f32x3", vertices, vec3);
    mesh.texcoords[0] = read_converted<Float2>(folder / "uv0.f32x2", vertices, st);
    mesh.texcoords[1] = read_converted<Float2>(folder / "uv1.f32x2", vertices, st);
    mesh.colors = read_converted<Rgba8>(folder / "color.u8x4", vertices, color);
    mesh.indices = read_array<std::uint32_t>(folder / "index.u32", 3 * triangles);
    for (const std::uint32_t i : mesh.indices)
        if (i >= vertices)
            throw Error(ExitCode::bad_file,
                        fmt::format("{}: {} names none of {} vertices",
                                    (folder / "index.u32").string(), i, vertices));
    return mesh;
}

void require_state(const Manifest& manifest) {
    manifest.require("alpha_func", {"GREATER", "0.5"});
    manifest.require("depth_func", {"LEQUAL"});
    manifest.require("depth_bits", {"24"});
    manifest.require("cull", {"BACK"});
    manifest.require("clear", {"0", "0", "0", "0"});
    manifest.require("color_bits", {"8", "8", "8", "8"});
}

}  // namespace

Inputs read_dump(const fs::path& folder) {
    const Manifest manifest(folder);
    require_state(manifest);
    const auto vertices = static_cast<std::size_t>(manifest.integer("vertices", 1, max_vertices));
    const auto triangles =
        static_cast<std::size_t>(manifest.integer("triangles", 1, 2 * max_vertices));
    const int edge = manifest.edge("texture");
    const auto texels = static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge);
    Inputs in;
    in.drawing = manifest.words("variant", 1).front();
    in.size = manifest.edge("size");
    in.mesh = read_mesh(folder, vertices, triangles);
    in.clip = read_converted<std::array<float, 4>>(folder / "clip.f32x4", vertices,
                                                   [](const std::array<float, 4>& v) {
                                                       return Vec4{v[0], v[1], v[2], v[3]};
                                                   });
    in.modelview = manifest.matrix("modelview");
    in.projection = manifest.matrix("projection");
    for (std::size_t u = 0; u < 2; ++u)
        for (std::size_t f = 0; f < 2; ++f) {
            const std::string name = fmt::format("{}_{}", u, f == 0 ? "front" : "back");
            in.textures[u][f] = {edge, edge,
                                 read_array<Rgba8>(folder / ("tex" + name + ".rgba8"), texels)};
            in.texture_matrices[u][f] = manifest.matrix("texture" + name);
        }
    return in;
}

}  // namespace twofold::bench
