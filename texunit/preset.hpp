#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// A numeric preset as a plain table: what each stage computes and on what evidence that stands.
/// `explain --preset` prints it; the arithmetic itself is in the header of the same name.
namespace twofold {

enum class Preset { ideal64, float32, gl13, nv2x, nv17, coarse8, custom };

/// The presets that are fixed; `custom` is what its settings say (custom.hpp).
inline constexpr std::array all_presets{Preset::ideal64, Preset::float32, Preset::gl13,
                                        Preset::nv2x,    Preset::nv17,    Preset::coarse8};

/// On what a rule stands: `spec` a public document or model of that chip family states it,
/// `measured` found exactly on captures of real silicon, `inferred` follows from a neighbouring
/// fact, `chosen` nobody public says and the project fixed a value. The first two count as sourced.
enum class Mark { spec, measured, inferred, chosen };

/// What one stage of the pipeline computes under a preset.
struct StageRule {
    std::string_view stage;
    std::string_view rule;  ///< number format and rounding
    Mark mark;
    std::string_view source;
};

struct MarkCounts {
    int sourced = 0;
    int inferred = 0;
    int chosen = 0;
};

std::string_view name_of(Preset preset);
std::string_view name_of(Mark mark);
/// `custom` included.
std::optional<Preset> preset_named(std::string_view name);

/// One sentence: what the preset is for.
std::string_view purpose_of(Preset preset);

/// Raised whenever any value of the table changes.
int version_of(Preset preset);

/// The stages in pipeline order.
std::span<const StageRule> stage_rules(Preset preset);

MarkCounts count_marks(Preset preset);

/// The only sentence that may be printed of a preset's faithfulness, with its counts.
std::string exactness_sentence(Preset preset);

}  // namespace twofold
