#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "factor/measured_data.hpp"
#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

constexpr std::size_t neighbours = 8;

/// Angle between the azimuths of two directions over pi, 0 to 1; 0 where one is the normal.
double azimuth_difference(Vec3 a, Vec3 b) {
    const double lengths = std::sqrt((a.x * a.x + a.y * a.y) * (b.x * b.x + b.y * b.y));
    if (lengths == 0.0) return 0.0;
    const double cosine = (a.x * b.x + a.y * b.y) / lengths;
    return exact::acos(cosine > 1.0 ? 1.0 : cosine < -1.0 ? -1.0 : cosine) / exact::pi;
}

Vec3 place_of(Vec3 wi, Vec3 wo) {
    const double sine_i = std::sqrt(wi.x * wi.x + wi.y * wi.y);
    const double sine_o = std::sqrt(wo.x * wo.x + wo.y * wo.y);
    return {sine_i * sine_o, azimuth_difference(wi, wo), wi.z * wo.z};
}

struct Place {
    Vec3 at;
    Rgb f;
};

/// A place and the square of its distance.
struct Near {
    double square;
    std::size_t index;
};

/// The nearest places, ascending; of equals the first stays in front.
std::array<Near, neighbours + 1> nearest(const std::vector<Place>& places, Vec3 at) {
    std::array<Near, neighbours + 1> found;
    found.fill({std::numeric_limits<double>::infinity(), 0});
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec3 across = places[i].at - at;
        Near candidate{dot(across, across), i};
        for (Near& kept : found)
            if (candidate.square < kept.square) std::swap(candidate, kept);
    }
    return found;
}

Rgb interpolated(const std::vector<Place>& places, Vec3 at) {
    const auto near = nearest(places, at);
    if (near[0].square == 0.0) return places[near[0].index].f;
    const double reach = std::sqrt(near.back().square);
    Rgb sum(0.0);
    double weights = 0.0;
    for (std::size_t k = 0;
         k < neighbours && near[k].square < std::numeric_limits<double>::infinity(); ++k) {
        const double distance = std::sqrt(near[k].square);
        const double root = reach < std::numeric_limits<double>::infinity()
                                ? (reach - distance) / (reach * distance)
                                : 1.0 / distance;
        sum += root * root * places[near[k].index].f;
        weights += root * root;
    }
    return weights > 0.0 ? sum / weights : places[near[0].index].f;
}

}  // namespace

std::function<Rgb(Vec3 wi, Vec3 wo)> scattered_value(std::vector<BrdfSample> samples) {
    const auto places = std::make_shared<std::vector<Place>>();
    for (const BrdfSample& s : samples) places->push_back({place_of(s.wi, s.wo), s.f});
    return [places](Vec3 wi, Vec3 wo) { return interpolated(*places, place_of(wi, wo)); };
}

}  // namespace twofold
