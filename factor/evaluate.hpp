#pragma once
#include "factor/brdf.hpp"

namespace twofold {

/// f(l, v; n) itself, one direction at a time: the text to read, and the oracle of the block
/// kernels. 0 where l or v is not above the horizon. Finite for all cosines down to 1e-30; towards
/// grazing Cook-Torrance grows as 1 / max(n.l, n.v), which is the formula's limit and not clamped
/// here.
/// @param n, v, l unit vectors: normal, to the viewer, to the light
/// @return per steradian, one value a channel
/// @source docs/method.md, section 3
Rgb evaluate(const Brdf& brdf, Vec3 n, Vec3 v, Vec3 l);

/// log D(m) of Beckmann's distribution, finite where D itself underflows.
/// @param cosine n.h, 0 < cosine <= 1
/// @param squared_tangent of the same angle; an argument of its own as 1 - cosine^2 would lose
/// digits
/// @param m rms slope, > 0
double log_beckmann(double cosine, double squared_tangent, double m);

/// Unpolarised reflectance of a smooth dielectric.
/// @param cosine v.h, 0 < cosine <= 1
/// @param f0 reflectance at cosine 1, 0 <= f0 < 1
double fresnel(double cosine, double f0);

/// Index of refraction (1 + sqrt f0) / (1 - sqrt f0).
double refractive_index(double f0);

/// The factor in front of F D G / ((n.l) (n.v)): 1/pi or 1/(4 pi).
double cook_torrance_constant(CookTorranceConstant constant);

/// Cosines that divide are raised to this: far below every visible angle, far above underflow.
inline constexpr double least_cosine = 1e-30;

/// Refuses a material whose formula has no value.
/// @throws Error(failure) that names the field and its value
void check(const Brdf& brdf);

}  // namespace twofold
