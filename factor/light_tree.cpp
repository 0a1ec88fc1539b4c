#include "factor/light_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "texunit/cube_map.hpp"
#include "texunit/fixed.hpp"

namespace twofold {

namespace {

constexpr int levels = 12;  ///< cuts of a face: cells of 1 / 4096 of its edge

/// Every second bit of the result is one of v.
std::uint32_t spread(std::uint32_t v) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < levels; ++bit) result |= (v >> bit & 1U) << (2 * bit);
    return result;
}

/// The cell of a direction at the finest level; cells of a coarser one are its leading bits.
std::uint32_t cell_of(Vec3 d) {
    const ProjectiveCoordinates<double> direction{d.x, d.y, d.z, 1.0};
    const CubeFace face = cube_face(direction);
    const auto at = on_face(face, direction);
    const auto step = [](double st) {
        return static_cast<std::uint32_t>(
            to_fixed(std::floor(st * (1 << levels)), 0, (1 << levels) - 1));
    };
    return static_cast<std::uint32_t>(face) << (2 * levels) | spread(step(at.t / at.q)) << 1 |
           spread(step(at.s / at.q));
}

double energy(Rgb w) { return w.x + w.y + w.z; }

/// Lights in the order of their cells, black ones left out.
struct SortedLights {
    std::vector<std::uint32_t> cell;
    std::vector<std::uint32_t> light;
};

SortedLights sorted(const DistantLights& lights) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
    for (std::uint32_t k = 0; k < lights.size(); ++k)
        if (energy(lights.weight(k)) > 0.0) order.emplace_back(cell_of(lights.direction(k)), k);
    std::stable_sort(order.begin(), order.end());
    SortedLights result;
    for (const auto& [cell, light] : order) {
        result.cell.push_back(cell);
        result.light.push_back(light);
    }
    return result;
}

LightNode node_of(const DistantLights& lights, const std::uint32_t* light, std::size_t count) {
    LightNode node;
    Vec3 mean(0.0);
    for (std::size_t k = 0; k < count; ++k) {
        node.weight += lights.weight(light[k]);
        mean += energy(lights.weight(light[k])) * lights.direction(light[k]);
    }
    node.direction = count == 1 ? lights.direction(light[0]) : normalized(mean);
    Rgb second(0.0);
    std::array<Vec3, 3> first{Vec3(0.0), Vec3(0.0), Vec3(0.0)};
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 off = lights.direction(light[k]) - node.direction;
        const Rgb w = lights.weight(light[k]);
        node.radius = max(node.radius, length(off));
        second += dot(off, off) * w;
        for (int c = 0; c < 3; ++c) first[static_cast<std::size_t>(c)] += w[c] * off;
    }
    node.second = max_component(second);
    for (const Vec3 f : first)
        node.first = max(node.first, length(f - dot(f, node.direction) * node.direction));
    return node;
}

/// Lights [first, end) of the sorted ones are a node at `level` cuts.
struct Span {
    std::size_t first, end;
};

/// The parts of a span that lie in one cell each after `level` cuts.
std::vector<Span> parts_of(const SortedLights& lights, Span span, int level) {
    const int shift = 2 * (levels - level);
    std::vector<Span> parts;
    for (std::size_t first = span.first; first < span.end;) {
        std::size_t end = first + 1;
        while (end < span.end && lights.cell[end] >> shift == lights.cell[first] >> shift) ++end;
        parts.push_back({first, end});
        first = end;
    }
    return parts;
}

}  // namespace

LightTree light_tree(const DistantLights& lights) {
    const SortedLights order = sorted(lights);
    LightTree tree;
    std::vector<Span> spans;
    const auto append = [&](const std::vector<Span>& parts) {
        for (const Span part : parts) {
            tree.nodes.push_back(
                node_of(lights, order.light.data() + part.first, part.end - part.first));
            spans.push_back(part);
        }
    };
    append(parts_of(order, {0, order.light.size()}, 0));
    tree.roots = static_cast<std::uint32_t>(tree.nodes.size());
    std::size_t begin = 0;
    for (int level = 1; level <= levels; ++level) {
        const std::size_t end = tree.nodes.size();
        for (std::size_t i = begin; i < end; ++i) {
            if (spans[i].end - spans[i].first < 2) continue;
            // Past the last cut the lights of a cell are its children.
            std::vector<Span> parts = parts_of(order, spans[i], level);
            if (level == levels) {
                parts.clear();
                for (std::size_t k = spans[i].first; k < spans[i].end; ++k)
                    parts.push_back({k, k + 1});
            }
            tree.nodes[i].child = static_cast<std::uint32_t>(tree.nodes.size());
            tree.nodes[i].children = static_cast<std::uint32_t>(parts.size());
            append(parts);
        }
        begin = end;
    }
    return tree;
}

}  // namespace twofold
