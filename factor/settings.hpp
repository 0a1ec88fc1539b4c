#pragma once

namespace twofold {

/// `qmr` on the normal equations, `qmr_augmented` on [I A; A^T 0]: factor/solve.hpp.
enum class Solver { qmr, lsmr, cgls, qmr_augmented };

/// How closely the factorisation follows the paper: `letter` has no smoothness and seam rows, no
/// row weights, no column scaling and stops by the iteration limit alone; `paper` adds what makes
/// it work.
enum class Method { letter, paper, best };

/// What stands in for the lighting function: the paper's product (or sum of positive ones), or one
/// of its relatives (docs/method.md, section 10).
enum class Model { product, svd, nd, mccool, slf, prefilter };

/// The norm of a row that normalised decomposition divides by: mean, root mean square, or largest.
enum class RowNorm { one, two, max };

/// The rows of a surface light field: the mesh's vertices, or the texels of a chart over its
/// texture coordinates.
enum class SurfaceRow { vertices, texels };

/// The images that a factor map is: two paraboloids, the six faces of a cube map, or OpenGL's
/// sphere map, which is tied to the eye. The last two are no choice of a scene: the one paraboloid
/// of a direction in the frame of the surface (mccool), and a texture over a mesh's coordinates
/// (slf).
enum class MapForm { dual_paraboloid, cube, sphere, hemisphere, chart };

/// What a map is divided by before it is stored (factor/scale.hpp).
enum class ScaleRule { maximum, percentile, best_split };

/// How the lighting function is summed at samples and held-out pairs: over every light, or over
/// lights merged where the lobe cannot tell them apart (factor/clustered_lighting.hpp).
enum class LightingSum { full, clustered };

/// Everything that decides the two factor maps, given the samples and the white point.
/// Defaults are those of the method preset `paper`.
struct FactorSettings {
    Method method = Method::paper;
    Model model = Model::product;
    MapForm map_form = MapForm::dual_paraboloid;
    int map_size = 64;     ///< R: texels along the edge of one face
    double guard = 0.875;  ///< g: a paraboloid's disc over half the map's edge, 0 < g <= 1
    int samples = 200000;  ///< S: (v, n) pairs of the fit
    int held_out = 20000;  ///< (v, n) pairs of the error figures, none of them in the fit
    LightingSum lighting_sum = LightingSum::clustered;
    double lighting_tolerance = 2e-3;  ///< of `clustered`: relative rms error wanted of the samples
    Solver solver = Solver::qmr;
    double tolerance = 1e-4;  ///< stop at |A^T r| <= tolerance |A^T b|
    int iteration_limit = 200;
    int stagnation_window = 60;       ///< iterations without progress that end the solve; 0 = off
    bool keep_best = true;            ///< return the best iterate, not the last
    bool remove_null_vectors = true;  ///< project the scale ambiguity out of the iteration
    double floor = 1e-3;       ///< epsilon: radiance is raised to floor * mean before the logarithm
    double cap = 4.0;          ///< radiance is lowered to cap * white before the logarithm; 0 = off
    double row_weight = 0.25;  ///< w: row i is weighted by (L_i / mean L)^w
    double smoothness = 1.0;   ///< lambda of the Laplacian rows; 0 = off
    double seam = 0.3;         ///< scale of the seam rows relative to the Laplacian rows; 0 = off
    bool column_scaling = true;  ///< solve A D^-1 y with D_j the norm of column j
    double fill_power = 2.0;  ///< p of the inverse-distance fill of texels that no sample touches
    int view_knots = 0;       ///< knots of the third factor g(n.v); 0 = none
    double view_smoothness = 0.1;  ///< of the second differences of the knots; 0 = off
    int terms = 1;  ///< J: products that passes add up, each its own maps; signed with svd and slf
    int rounds = 20;  ///< of alternating least squares over all terms, with svd and slf
    RowNorm row_norm = RowNorm::two;                 ///< of nd
    SurfaceRow surface_rows = SurfaceRow::vertices;  ///< of slf
    int refinement = 0;               ///< steps of the fit to linearly filtered texels; 0 = none
    double refinement_weight = 0.75;  ///< its row weights are (L_i / mean L)^this / L_i
    ScaleRule scale = ScaleRule::maximum;
    double scale_percentile = 99.9;  ///< of the rule `percentile`
    int combiner_scale = 4;          ///< the largest that a combiner may apply: 1, 2 or 4
    bool shortcuts = false;          ///< diffuse materials and one Phong lobe in closed form
};

/// The names that scene files and reports use.
const char* name_of(Method method);
const char* name_of(Model model);
const char* name_of(MapForm form);
const char* name_of(Solver solver);
const char* name_of(LightingSum sum);

/// The settings of a method preset, every field at its documented value.
FactorSettings method_preset(Method method);

}  // namespace twofold
