#pragma once
#include <memory>
#include <optional>
#include <string>

#include "factor/half_angle.hpp"
#include "factor/measured_data.hpp"
#include "factor/product_brdf.hpp"

namespace twofold {

enum class MeasuredFormat { merl, cornell, rgl };

/// What stands in for directions that were not measured: the paper's product p(l) q(h) p(v) fitted
/// to all that was, or the measurements themselves, interpolated and their gaps filled.
enum class Fill { homomorphic, interpolate };

/// A measured material as a scene names it.
struct MeasuredFile {
    MeasuredFormat format = MeasuredFormat::merl;
    std::string path;
    Fill fill = Fill::homomorphic;
};

/// What was found in a file and done with it.
struct MeasuredReport {
    std::string sha256;                   ///< of the file
    std::string recognised;               ///< name in the list of known files, or empty
    std::array<ValueCounts, 3> counts;    ///< of the stored values
    std::size_t samples = 0;              ///< pairs of directions that were used
    std::array<std::size_t, 3> filled{};  ///< table nodes without a value; interpolate
    std::optional<std::array<ProductFit, 3>> factors;  ///< homomorphic
    double lobe_half_width = 0.0;  ///< theta_h at which the largest f at theta_d = 0 has halved
};

/// A measured BRDF ready for the lighting sum: the one of table and product that `fill` names.
struct MeasuredModel {
    Fill fill = Fill::homomorphic;
    HalfAngleTable table;
    ProductBrdf product;
    MeasuredReport report;
};

/// @throws Error(failure) if no channel has a value above 0
MeasuredModel make_model(const MeasuredData& data, Fill fill, int threads);

/// A measured material. Without its model, as a scene file gives it, it has no value.
struct MeasuredBrdf {
    MeasuredFile source;
    std::shared_ptr<const MeasuredModel> model;
};

}  // namespace twofold
