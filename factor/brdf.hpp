#pragma once
#include <variant>
#include <vector>

#include "factor/measured_brdf.hpp"
#include "texunit/linear.hpp"

namespace twofold {

/// One Beckmann slope distribution D(m) of a Cook-Torrance surface and its weight in the sum.
struct BeckmannLobe {
    double m = 0.2;       ///< rms slope, > 0
    double weight = 1.0;  ///< w_j, >= 0; the weights sum to 1
};

/// The constant in front of F D G: `pi1981` is 1/pi of the paper, `modern4` is 1/4, with D
/// normalised by pi; a quarter of the former (method: one printing of D gives it exactly).
enum class CookTorranceConstant { pi1981, modern4 };

/// f = diffuse / pi + specular F D G / (pi (n.l) (n.v)).
/// @source Cook & Torrance, A Reflectance Model for Computer Graphics, 1981
struct CookTorrance {
    Rgb diffuse{0.0};   ///< d rho, albedo of the diffuse part
    Rgb specular{1.0};  ///< s
    Rgb f0{0.04};  ///< Fresnel reflectance at normal incidence, 0 <= f0 < 1; eta follows from it
    std::vector<BeckmannLobe> lobes{BeckmannLobe{}};
    CookTorranceConstant constant = CookTorranceConstant::pi1981;
};

/// f = diffuse / pi + specular (N + 2) / (2 pi) max(0, r_v.l)^N.
/// @source Lafortune & Willems, Using the Modified Phong Reflectance Model, 1994
struct ModifiedPhong {
    Rgb diffuse{0.5};        ///< k_d
    Rgb specular{0.5};       ///< k_s; k_d + k_s <= 1 conserves energy
    double exponent = 50.0;  ///< N >= 0
};

using Brdf = std::variant<CookTorrance, ModifiedPhong, MeasuredBrdf>;

}  // namespace twofold
