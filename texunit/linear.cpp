#include "texunit/linear.hpp"

#include <cmath>

namespace twofold {

double length(Vec3 a) { return std::sqrt(dot(a, a)); }

Vec3 normalized(Vec3 a) { return a / length(a); }

}  // namespace twofold
