#pragma once
#include "scenes/scene.hpp"

namespace twofold {

/// World to eye space: the eye at the origin, looking down -z, y up. @source OpenGL, gluLookAt
Mat4 view_matrix(const Camera& camera);

/// Eye to clip space, perspective. @param aspect width / height @source OpenGL, gluPerspective
Mat4 projection_matrix(const Camera& camera, double aspect);

/// Object to world space: scale, then turn about y, then move.
Mat4 model_matrix(const FactoredObject& object);

}  // namespace twofold
