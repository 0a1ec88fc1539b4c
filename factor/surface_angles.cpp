#include "factor/surface_angles.hpp"

#include <cmath>

#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

double acos_within(double cosine) {
    return exact::acos(cosine > 1.0 ? 1.0 : cosine < -1.0 ? -1.0 : cosine);
}

/// asin(x) for |x| <= 0.1: Taylor's series, cut below 1e-13 of the result.
double small_asin(double x) {
    const double s = x * x;
    return x * (1.0 + s * (1.0 / 6.0 +
                           s * (3.0 / 40.0 + s * (15.0 / 336.0 +
                                                  s * (105.0 / 3456.0 + s * (945.0 / 42240.0))))));
}

}  // namespace

double polar_angle(Vec3 d) {
    const double half_chord = 0.5 * length(d - Vec3(0.0, 0.0, 1.0));
    return half_chord <= 0.1 ? 2.0 * small_asin(half_chord) : acos_within(d.z);
}

double azimuth(double x, double y) {
    const double length = std::sqrt(x * x + y * y);
    if (length == 0.0) return 0.0;
    const double angle = acos_within(x / length);
    return y < 0.0 ? -angle : angle;
}

}  // namespace twofold
