#include "factor/tensor_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "texunit/byte_cursor.hpp"

namespace twofold {
namespace {

constexpr std::string_view magic{"tensor_file\0", 12};
constexpr unsigned type_f32 = 10;
constexpr std::uint32_t most_fields = 256;
constexpr std::uint16_t most_dimensions = 8;

/// Where a field lies.
struct Entry {
    std::string name;
    unsigned type = 0;
    std::uint64_t offset = 0;
    std::vector<std::uint64_t> shape;
};

std::string text_of(std::span<const unsigned char> bytes) { return {bytes.begin(), bytes.end()}; }

void check_header(ByteCursor& at) {
    if (text_of(at.take(magic.size())) != magic) at.fail("no tensor file");
    const auto major = at.value<std::uint8_t>();
    const auto minor = at.value<std::uint8_t>();
    if (major != 1 || minor != 0)
        at.fail(fmt::format("tensor file of version {}.{}, not 1.0", major, minor));
}

Entry read_entry(ByteCursor& at) {
    Entry entry;
    entry.name = text_of(at.take(at.value<std::uint16_t>()));
    const auto dimensions = at.value<std::uint16_t>();
    if (dimensions > most_dimensions) at.fail(fmt::format("a field of {} dimensions", dimensions));
    entry.type = at.value<std::uint8_t>();
    entry.offset = at.value<std::uint64_t>();
    for (int i = 0; i < dimensions; ++i) entry.shape.push_back(at.value<std::uint64_t>());
    return entry;
}

/// Number of values, checked against the bytes that the file has from the field's offset on.
std::size_t count_values(const ByteCursor& at, const Entry& entry) {
    std::uint64_t count = 1;
    for (const std::uint64_t edge : entry.shape) {
        if (edge == 0 || edge > at.left() / 4 / count)
            at.fail(fmt::format("field '{}' does not fit: [{}]", entry.name,
                                fmt::join(entry.shape, ", ")));
        count *= edge;
    }
    return static_cast<std::size_t>(count);
}

Tensor read_tensor(ByteCursor at, const Entry& entry) {
    if (entry.type != type_f32)
        at.fail(fmt::format("field '{}' has type {}, not f32", entry.name, entry.type));
    at.seek(entry.offset);
    Tensor tensor{{entry.shape.begin(), entry.shape.end()},
                  std::vector<float>(count_values(at, entry))};
    for (float& value : tensor.values) {
        value = at.value<float>();
        if (!std::isfinite(value)) at.fail(fmt::format("field '{}' is not finite", entry.name));
    }
    return tensor;
}

}  // namespace

std::map<std::string, Tensor> parse_tensors(std::span<const unsigned char> bytes,
                                            std::span<const std::string_view> wanted,
                                            std::string_view name) {
    ByteCursor at(bytes, name);
    check_header(at);
    const auto fields = at.value<std::uint32_t>();
    if (fields > most_fields) at.fail(fmt::format("{} fields", fields));
    std::map<std::string, Tensor> tensors;
    // Fields that shared their bytes could ask for many times the file's length.
    std::size_t room = bytes.size() / 4;
    for (std::uint32_t i = 0; i < fields; ++i) {
        const Entry entry = read_entry(at);
        if (std::find(wanted.begin(), wanted.end(), entry.name) != wanted.end() &&
            !tensors.contains(entry.name)) {
            const Tensor& read = tensors.emplace(entry.name, read_tensor(at, entry)).first->second;
            if (read.values.size() > room) at.fail("fields lie over each other");
            room -= read.values.size();
        }
    }
    for (const std::string_view field : wanted)
        if (!tensors.contains(std::string(field))) at.fail(fmt::format("no field '{}'", field));
    return tensors;
}

}  // namespace twofold
