#include "factor/distant_lights.hpp"

#include <cmath>
#include <utility>

namespace twofold {
namespace {

/// Far above the rounding of a dot product, far below any angle that matters: a patch is left out
/// only where every n.l as the kernel rounds it is certainly not positive.
constexpr double margin = 1e-9;

/// Direction of the sum of the lights of [first, end); any direction where they cancel.
Vec3 mean_direction(const DistantLights& lights, std::size_t first, std::size_t end) {
    Vec3 sum(0.0);
    for (std::size_t k = first; k < end; ++k) {
        sum += lights.direction(k);
    }
    return length(sum) > 1e-6 ? normalized(sum) : Vec3(0.0, 0.0, 1.0);
}

bool all_dark(const DistantLights& lights, std::size_t first, std::size_t end) {
    for (std::size_t k = first; k < end; ++k) {
        if (lights.weight(k) != Rgb(0.0)) {
            return false;
        }
    }
    return true;
}

LightCone bounding_cone(const DistantLights& lights, std::size_t first, std::size_t end) {
    LightCone cone;
    cone.axis = mean_direction(lights, first, end);
    cone.dark = all_dark(lights, first, end);
    double cosine = 1.0;
    for (std::size_t k = first; k < end; ++k) {
        const double c = dot(cone.axis, lights.direction(k));
        cosine = c < cosine ? c : cosine;
    }
    if (cosine > 0.0) {
        cone.sine = std::sqrt(1.0 - cosine * cosine + margin) + margin;
    }
    return cone;
}

}  // namespace

void DistantLights::push_back(Vec3 direction, Rgb weight) {
    x.push_back(direction.x);
    y.push_back(direction.y);
    z.push_back(direction.z);
    r.push_back(weight.x);
    g.push_back(weight.y);
    b.push_back(weight.z);
}

DistantLights turned(const DistantLights& lights, const Mat3& turn) {
    DistantLights result;
    for (std::size_t k = 0; k < lights.size(); ++k)
        result.push_back(normalized(turn * lights.direction(k)), lights.weight(k));
    return bound_blocks(std::move(result));
}

DistantLights bound_blocks(DistantLights lights) {
    lights.cones.clear();
    for (std::size_t first = 0; first < lights.size(); first += light_patch) {
        const std::size_t rest = lights.size() - first;
        const std::size_t end = first + (rest < light_patch ? rest : light_patch);
        lights.cones.push_back(bounding_cone(lights, first, end));
    }
    return lights;
}

}  // namespace twofold
