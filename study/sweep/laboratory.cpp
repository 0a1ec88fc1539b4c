#include "study/sweep/laboratory.hpp"

#include "study/pictures.hpp"
#include "study/results_json.hpp"
#include "study/run.hpp"
#include "study/sweep/cell_names.hpp"
#include "study/sweep/errors.hpp"
#include "study/sweep/machine.hpp"
#include "study/sweep/work.hpp"
#include "texunit/error.hpp"

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

/// A picture has up to 50 bytes a pixel in memory.
constexpr std::size_t most_waiting_pixels = std::size_t{1} << 22;
constexpr std::size_t most_waiting = 16;

Json to_json(const CellErrors& e) {
    Json json = to_json(e.steps);
    json["real_rms_steps"] = e.real_rms_steps;
    json["relative_rms"] = e.relative_rms;
    json["clipped_share"] = e.clipped_share;
    json["vanished_share"] = e.vanished_share;
    return json;
}

/// Null where there is no reference, or no pixel that both show.
Json errors_json(const Framebuffer& picture, const std::shared_ptr<const Framebuffer>& reference,
                 const std::vector<bool>& outline) {
    if (!reference) return nullptr;
    const CellErrors errors = errors_between(picture, *reference, outline);
    return errors.steps.pixels_compared > 0 ? to_json(errors) : Json(nullptr);
}

Json to_json(const Seconds& s) { return {{"processor", s.processor}, {"wall", s.wall}}; }

Json to_json(const Spread& s) {
    return {{"least", s.least}, {"median", s.median}, {"quartiles", {s.low, s.high}}};
}

/// The ratio is of least times: other work on the machine makes a frame slower, never quicker.
Json frame_json(const TimedFrame& frame, const TimedFrame& common) {
    return {{"rounds", frame.rounds()},
            {"processor", to_json(frame.processor())},
            {"wall", to_json(frame.wall())},
            {"anchor_processor", to_json(common.processor())},
            {"ratio_to_anchor", frame.processor().least / common.processor().least}};
}

Json to_json(const FrameWork& w) {
    return {{"passes", w.passes},
            {"texture_bytes", w.texture_bytes},
            {"vertices", w.vertices},
            {"fragments", w.fragments},
            {"alpha_failed", w.alpha_failed},
            {"depth_failed", w.depth_failed},
            {"written", w.written},
            {"texel_fetches", w.texel_fetches}};
}

Json to_json(const CardPrediction& p) {
    return {{"fill_seconds", p.fill_seconds},
            {"memory_seconds", p.memory_seconds},
            {"seconds", p.seconds}};
}

/// What is drawn and how, in the names of study files.
Json settings_json(const Cell& cell) {
    const Preset preset = cell.scene.presets.front();
    return {{"preset", name_of(preset)},
            {"preset_version", version_of(preset)},
            {"technique", scene_io::name_in(technique_names, cell.draw.technique)},
            {"way", scene_io::name_in(draw_way_names, cell.draw.way)},
            {"filter", scene_io::name_in(texel_filter_names, cell.draw.filter)}};
}

/// The card holds bytes: presets that hold floats have no prediction.
Json prediction_json(const Cell& cell, const FrameWork& work, const Frame& frame) {
    if (samples_float_textures(cell.scene.presets.front(), cell.scene.custom)) return nullptr;
    return to_json(predict(work, frame, mx440_8x));
}

}  // namespace

Laboratory::Laboratory(Cell anchor, int samples, TimingRule rule, int threads, StepListener listen)
    : anchor_(std::move(anchor)), rule_(rule), shared_(samples, threads, std::move(listen)) {}

TimedFrame& Laboratory::common_frame() {
    if (!anchor_drawing_) {
        anchor_inputs_ = shared_.inputs_of(anchor_).inputs;
        anchor_drawing_ = prepare(anchor_, anchor_inputs_);
    }
    if (!common_) common_.emplace(anchor_drawing_->draw, rule_);
    return *common_;
}

CellFindings Laboratory::measured(const Cell& cell) {
    const SharedWork::Inputs in = shared_.inputs_of(cell);
    Waiting& own = waiting_.emplace_back();
    own.inputs = in.inputs;
    own.drawing = prepare(cell, own.inputs);
    own.time.emplace(own.drawing.draw, rule_);
    common_frame().measure();
    if (own.time->wants_more()) own.time->measure();
    const Drawing& drawing = own.drawing;
    const Framebuffer picture = drawing.picture();
    const std::vector<bool> outline = shared_.outline_of(cell, in.inputs);
    Json result = settings_json(cell);
    result["picture"] = {{"width", picture.width}, {"height", picture.height}};
    result["picture"]["hash"] = hash_of(picture);
    result["white"] = in.inputs.white;
    result["errors"] = {
        {"exact", errors_json(picture, shared_.truth_of(cell, in.inputs), outline)},
        {"ideal64", errors_json(picture, shared_.ideal_of(cell, in.inputs), outline)}};
    result["fit"] = in.lit ? factors_json(cell.scene, *in.lit).at("materials") : Json(nullptr);
    result["warnings"] = warnings_of(cell.scene, *in.inputs.materials);
    result["counts"] = result["card"] = nullptr;
    if (drawing.frame) {
        const FrameWork work = shared_.work_of(cell, *drawing.frame);
        result["counts"] = to_json(work);
        result["card"] = prediction_json(cell, work, *drawing.frame);
    }
    result["times"] = {{"sampling", to_json(in.sampling)}, {"factoring", to_json(in.factoring)}};
    result["times"]["processor"] = processor_name();
    result["times"]["compiler"] = compiler_name();
    result["times"]["frame"] = frame_json(*own.time, common_frame());
    waiting_pixels_ += picture.bytes.size();
    return {std::move(result), byte_image(picture)};
}

CellFindings Laboratory::measure(const Cell& cell) {
    common_frame();  // an error of the common cell's is the study's
    const std::size_t waited = waiting_.size();
    try {
        return measured(cell);
    } catch (const Error& e) {
        waiting_.resize(waited);
        // A file that could not be read this time says nothing about the cell.
        if (e.code() == ExitCode::bad_file) throw;
        Json result = settings_json(cell);
        result["failed"] = e.what();
        return {std::move(result), {}};
    }
}

bool Laboratory::full() const {
    return waiting_.size() >= most_waiting || waiting_pixels_ >= most_waiting_pixels;
}

std::vector<Json> Laboratory::time_in_turn() {
    std::vector<TimedFrame*> frames;
    for (Waiting& w : waiting_) frames.push_back(&*w.time);
    twofold::time_in_turn(frames, common_frame());
    std::vector<Json> times;
    for (const TimedFrame* frame : frames) times.push_back(frame_json(*frame, common_frame()));
    waiting_.clear();
    waiting_pixels_ = 0;
    common_.reset();
    return times;
}

}  // namespace twofold
