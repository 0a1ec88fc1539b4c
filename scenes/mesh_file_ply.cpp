#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <string>
#include <string_view>

#include "scenes/mesh_file.hpp"
#include "scenes/mesh_normals.hpp"
#include "scenes/ply_header.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/number_text.hpp"

namespace twofold {
namespace {

constexpr std::size_t max_ply_bytes = std::size_t{1} << 31;
constexpr double max_coordinate = 1e30;  // as for OBJ: squares must stay finite
constexpr std::size_t no_property = static_cast<std::size_t>(-1);

using namespace ply;

/// The values of the data section, one after the other; each type fits into a double.
class Values {
  public:
    Values(std::string_view data, bool binary, std::string name)
        : data_(data), binary_(binary), name_(std::move(name)) {}

    double next(Type type) { return binary_ ? next_binary(type) : next_word(); }

    /// Bytes that a value takes at least, and bytes left: what does not fit is refused before
    /// allocation.
    std::size_t least_bytes(Type type) const { return binary_ ? type.bytes : 1; }
    std::size_t remaining() const { return data_.size(); }
    const std::string& name() const { return name_; }

  private:
    double next_word() {
        const std::string_view word = take_word(data_);
        if (word.empty()) fail(name_, "truncated");
        const auto value = parse_real(word);
        if (!value) fail(name_, fmt::format("'{}' is not a number", printable(word, 40)));
        return *value;
    }

    /// Put together byte by byte, so that the machine's own byte order does not matter.
    double next_binary(Type type) {
        if (data_.size() < type.bytes) fail(name_, "truncated");
        std::uint64_t bits = 0;
        for (std::size_t i = type.bytes; i-- > 0;)
            bits = bits << 8 | static_cast<unsigned char>(data_[i]);
        data_.remove_prefix(type.bytes);
        return to_double(bits, type);
    }

    static double to_double(std::uint64_t bits, Type type) {
        if (type.kind == Kind::unsigned_integer) return static_cast<double>(bits);
        if (type.kind == Kind::real && type.bytes == 8) return std::bit_cast<double>(bits);
        if (type.kind == Kind::real)
            return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
        return static_cast<double>(static_cast<std::int64_t>((bits ^ sign) - sign));
    }

    std::string_view data_;
    bool binary_;
    std::string name_;
};

std::size_t find_property(const Element& element, std::string_view name) {
    for (std::size_t i = 0; i < element.properties.size(); ++i)
        if (element.properties[i].name == name) return i;
    return no_property;
}

/// One vertex, face or other item: its single values by property, and the one list that is wanted.
struct Row {
    std::vector<double> single;
    std::vector<double> list;
};

/// Reads the items of one element in turn into a row that is used again.
class RowReader {
  public:
    RowReader(const Element& element, Values& values, std::size_t wanted_list)
        : element_(element), values_(values), wanted_list_(wanted_list) {
        row_.single.resize(element.properties.size());
        check_count();
    }

    const Row& next() {
        row_.list.clear();
        for (std::size_t i = 0; i < element_.properties.size(); ++i) {
            const Property& property = element_.properties[i];
            if (property.count)
                read_list(property, i == wanted_list_);
            else
                row_.single[i] = values_.next(property.type);
        }
        return row_;
    }

  private:
    /// An item of at least one byte also bounds how often next() can be called.
    void check_count() const {
        std::size_t least = 0;
        for (const Property& p : element_.properties)
            least += values_.least_bytes(p.count.value_or(p.type));
        if (least == 0)
            fail(values_.name(), "element '" + printable(element_.name) + "' has no properties");
        if (element_.count > values_.remaining() / least)
            fail(values_.name(), fmt::format("truncated: no room for {} items of element '{}'",
                                             element_.count, printable(element_.name)));
    }

    void read_list(const Property& property, bool wanted) {
        const double count = values_.next(*property.count);
        const double room =
            static_cast<double>(values_.remaining() / values_.least_bytes(property.type));
        if (!(count >= 0.0 && count <= room) || count != std::floor(count))
            fail(values_.name(), fmt::format("a list of {} values in element '{}'", count,
                                             printable(element_.name)));
        for (double i = 0.0; i < count; i += 1.0) {
            const double value = values_.next(property.type);
            if (wanted) row_.list.push_back(value);
        }
    }

    const Element& element_;
    Values& values_;
    std::size_t wanted_list_;
    Row row_;
};

void skip(const Element& element, Values& values) {
    if (element.properties.empty()) return;
    RowReader rows(element, values, no_property);
    for (std::size_t i = 0; i < element.count; ++i) rows.next();
}

/// Where three properties stand in a row.
struct Columns {
    std::size_t x, y, z;
    bool complete() const { return x != no_property && y != no_property && z != no_property; }

    Vec3 of(const Row& row, std::size_t item, const std::string& name) const {
        const Vec3 value(row.single[x], row.single[y], row.single[z]);
        for (int c = 0; c < 3; ++c)
            if (!(value[c] >= -max_coordinate && value[c] <= max_coordinate))
                fail(name, fmt::format("vertex {}: {} is out of range", item, value[c]));
        return value;
    }
};

void require_single_values(const Element& element, const std::string& name) {
    for (const Property& property : element.properties)
        if (property.count) fail(name, "a list in PLY element 'vertex'");
}

void read_vertices(const Element& element, Values& values, Mesh& mesh) {
    if (element.count > max_mesh_vertices)
        fail(values.name(),
             fmt::format("{} vertices, allowed are {}", element.count, max_mesh_vertices));
    require_single_values(element, values.name());
    const auto column = [&](const char* name) { return find_property(element, name); };
    const Columns position{column("x"), column("y"), column("z")};
    const Columns normal{column("nx"), column("ny"), column("nz")};
    if (!position.complete()) fail(values.name(), "PLY element 'vertex' without x, y and z");
    RowReader rows(element, values, no_property);
    mesh.positions.reserve(element.count);
    mesh.normals.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
        const Row& row = rows.next();
        mesh.positions.push_back(position.of(row, i, values.name()));
        mesh.normals.push_back(normal.complete() ? normal.of(row, i, values.name()) : Vec3(0.0));
    }
}

std::uint32_t vertex_index(double value, std::size_t vertices, std::size_t face,
                           const std::string& name) {
    if (!(value >= 0.0 && value < static_cast<double>(vertices)) || value != std::floor(value))
        fail(name, fmt::format("face {}: index {} into {} vertices", face, value, vertices));
    return static_cast<std::uint32_t>(value);
}

void append_fan(const std::vector<double>& polygon, std::size_t face, const std::string& name,
                Mesh& mesh) {
    if (polygon.size() < 3)
        fail(name, fmt::format("face {}: {} corners, at least 3 are needed", face, polygon.size()));
    if (mesh.indices.size() / 3 + polygon.size() - 2 > max_mesh_triangles)
        fail(name, fmt::format("more than {} triangles", max_mesh_triangles));
    const auto index = [&](std::size_t corner) {
        return vertex_index(polygon[corner], mesh.positions.size(), face, name);
    };
    for (std::size_t i = 2; i < polygon.size(); ++i)
        mesh.indices.insert(mesh.indices.end(), {index(0), index(i - 1), index(i)});
}

void read_faces(const Element& element, Values& values, Mesh& mesh) {
    std::size_t list = find_property(element, "vertex_indices");
    if (list == no_property) list = find_property(element, "vertex_index");
    if (list == no_property || !element.properties[list].count)
        fail(values.name(), "PLY element 'face' without a list vertex_indices");
    RowReader rows(element, values, list);
    for (std::size_t i = 0; i < element.count; ++i)
        append_fan(rows.next().list, i, values.name(), mesh);
}

/// Elements come in the order of the header; faces before vertices would index nothing yet.
Mesh read_elements(const Header& header, Values& values) {
    Mesh mesh;
    for (const Element& element : header.elements) {
        if (element.name == "vertex" && mesh.positions.empty())
            read_vertices(element, values, mesh);
        else if (element.name == "face")
            read_faces(element, values, mesh);
        else
            skip(element, values);
    }
    if (mesh.indices.empty()) fail(values.name(), "no faces");
    return mesh;
}

void complete_normals(Mesh& mesh) {
    bool missing = false;
    for (const Vec3& normal : mesh.normals) missing = missing || !has_direction(normal);
    const std::vector<Vec3> computed =
        missing ? vertex_normals(mesh.positions, mesh.indices) : mesh.normals;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        mesh.normals[i] = unit_or(mesh.normals[i], computed[i]);
}

}  // namespace

Mesh parse_ply(std::string_view content, const std::string& name) {
    if (is_git_lfs_pointer(
            {reinterpret_cast<const unsigned char*>(content.data()), content.size()}))
        fail(name, "a Git LFS pointer instead of the mesh; fetch it with 'git lfs pull'");
    const Header header = parse_header(content, name);
    Values values(header.data, header.binary, name);
    Mesh mesh = read_elements(header, values);
    complete_normals(mesh);
    return mesh;
}

Mesh read_ply(const std::filesystem::path& path) {
    return parse_ply(read_text_file(path, max_ply_bytes), path.string());
}

}  // namespace twofold
