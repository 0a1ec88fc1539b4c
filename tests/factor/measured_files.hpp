#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "factor/measured_data.hpp"
#include "texunit/error.hpp"
#include "texunit/random.hpp"

/// Files of measured BRDFs as the tests write them.
namespace twofold::cases {

using Bytes = std::vector<unsigned char>;

template <class T>
void put(Bytes& bytes, T value) {
    std::uint64_t bits = 0;
    if constexpr (sizeof(T) == 8)
        bits = std::bit_cast<std::uint64_t>(value);
    else if constexpr (std::is_same_v<T, float>)
        bits = std::bit_cast<std::uint32_t>(value);
    else
        bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i)
        bytes.push_back(static_cast<unsigned char>(bits >> (8 * i)));
}

inline constexpr std::size_t merl_plane = 90 * 90 * 180;

/// A MERL file; stored(channel, theta_h index, theta_d index, phi_d index).
inline Bytes merl_file(const std::function<double(int, int, int, int)>& stored) {
    Bytes bytes;
    bytes.reserve(12 + 24 * merl_plane);
    for (const std::int32_t edge : {90, 90, 180}) put(bytes, edge);
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 90; ++i)
            for (int j = 0; j < 90; ++j)
                for (int k = 0; k < 180; ++k) put(bytes, stored(c, i, j, k));
    return bytes;
}

/// A field of a tensor file, its values a function of their number.
struct Field {
    std::string name;
    std::vector<std::uint64_t> shape;
    std::function<float(std::size_t)> value;
};

inline Bytes tensor_file(std::span<const Field> fields) {
    Bytes bytes;
    for (const char c : std::string_view("tensor_file\0", 12))
        put(bytes, static_cast<unsigned char>(c));
    bytes.push_back(1);
    bytes.push_back(0);
    put(bytes, static_cast<std::uint32_t>(fields.size()));
    std::uint64_t offset = bytes.size();
    for (const Field& f : fields) offset += 2 + f.name.size() + 2 + 1 + 8 + 8 * f.shape.size();
    Bytes data;
    for (const Field& f : fields) {
        put(bytes, static_cast<std::uint16_t>(f.name.size()));
        for (const char c : f.name) put(bytes, static_cast<unsigned char>(c));
        put(bytes, static_cast<std::uint16_t>(f.shape.size()));
        bytes.push_back(10);
        put(bytes, offset + data.size());
        std::size_t count = 1;
        for (const std::uint64_t edge : f.shape) {
            put(bytes, edge);
            count *= static_cast<std::size_t>(edge);
        }
        for (std::size_t i = 0; i < count; ++i) put(data, f.value(i));
    }
    bytes.insert(bytes.end(), data.begin(), data.end());
    return bytes;
}

/// An RGL material of small tables: even distributions, colours by colour(slice, channel).
inline std::vector<Field> rgl_fields(const std::function<float(std::size_t, std::size_t)>& colour) {
    const auto one = [](std::size_t) { return 1.0F; };
    return {
        {"theta_i", {3}, [](std::size_t i) { return 0.75F * static_cast<float>(i); }},
        {"sigma", {2, 4}, one},
        {"ndf", {2, 4}, one},
        {"vndf", {1, 3, 4, 4}, one},
        {"rgb", {1, 3, 3, 4, 4}, [colour](std::size_t i) { return colour(i / 48, i / 16 % 3); }}};
}

/// A Cornell file of two wavelengths over a grid of directions.
inline std::string cornell_file(const std::function<double(double, double, double)>& f) {
    std::string text = "# written by a test\n2\n500 600 # nm\n";
    for (int i = 1; i < 8; ++i)
        for (int o = 0; o < 8; ++o)
            for (int p = 0; p < 6; ++p) {
                const double ti = 0.19 * i, to = 0.17 * o, phi = 0.6 * p;
                const double value = f(ti, to, phi);
                text += std::to_string(ti) + " 0 " + std::to_string(to) + " " +
                        std::to_string(phi) + " " + std::to_string(value) + " " +
                        std::to_string(value) + "\n";
            }
    return text;
}

/// `parse` on `count` damaged copies of a seed: bytes changed, cut off, doubled. Each is either
/// read or refused as a bad file; everything else is an exception that leaves the test.
/// @return how many were refused
template <class Parse>
int replay_damaged(const Bytes& seed, int count, std::size_t head, const Parse& parse) {
    int refused = 0;
    for (int i = 0; i < count; ++i) {
        Bytes bytes = seed;
        const auto draw = [&](std::uint64_t k, std::uint64_t below) {
            return static_cast<std::size_t>(random_u64(static_cast<std::uint64_t>(i), k) % below);
        };
        const std::size_t changes = 1 + draw(0, 4);
        for (std::size_t k = 0; k < changes; ++k) {
            const std::size_t reach =
                draw(4 * k + 1, 2) == 0 ? std::min(head, bytes.size()) : bytes.size();
            bytes[draw(4 * k + 2, reach)] =
                static_cast<unsigned char>(draw(4 * k + 3, 3) == 0 ? 0xff : draw(4 * k + 4, 256));
        }
        if (draw(99, 4) == 0) bytes.resize(draw(98, bytes.size()) + 1);
        try {
            parse(bytes);
        } catch (const Error& error) {
            if (error.code() != ExitCode::bad_file) throw;
            ++refused;
        }
    }
    return refused;
}

}  // namespace twofold::cases
