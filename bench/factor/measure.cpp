#include "bench/factor/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/draw/machine.hpp"
#include "bench/draw/timing.hpp"
#include "bench/factor/against.hpp"
#include "bench/factor/own_process.hpp"
#include "bench/factor/peer.hpp"
#include "factor/directions.hpp"
#include "factor/factorize.hpp"
#include "factor/lighting.hpp"
#include "factor/solve_channels.hpp"
#include "factor/system.hpp"
#include "scenes/lighting.hpp"
#include "scenes/scene_file.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"

namespace twofold::bench {
namespace {

constexpr int light_count = 2048, sampled_views = 2000, fitted_samples = 100000, iterations = 40;

const CookTorrance material{Rgb(0.3), Rgb(0.7), Rgb(0.04), {{0.2, 1.0}}};

/// A sky over the whole sphere, its lights spread evenly.
DistantLights sky() {
    DistantLights lights;
    for (int i = 0; i < light_count; ++i) {
        const double y = 1.0 - 2.0 * (i + 0.5) / light_count;
        const double r = std::sqrt(1.0 - y * y), turn = 2.399963229728653 * i;
        const double radiance = (y > 0.0 ? 0.4 + 0.6 * y : 0.1) * 4.0 * exact::pi / light_count;
        lights.push_back({r * exact::cos(turn), y, r * exact::sin(turn)},
                         Rgb(radiance, 0.9 * radiance, 0.8 * radiance));
    }
    return bound_blocks(std::move(lights));
}

/// Radiance with the shape of a real one, at the cost of a few operations: what the solve is timed
/// on does not matter to it.
LightingSamples cheap_samples(int count, int first = 0) {
    LightingSamples samples{surface_views(count, 0, first), {}};
    const Vec3 l = normalized(Vec3(0.4, 0.5, 0.75));
    for (const SurfaceView& at : samples.at) {
        const double lobe = std::max(dot(pi_2(at), l), 0.0);
        const double value = 0.1 + std::max(dot(at.n, l), 0.0) * (0.3 + lobe * lobe);
        samples.radiance.emplace_back(value, 0.9 * value * value, 0.8 * value);
    }
    return samples;
}

FactorSettings settings_of(int map_size) {
    FactorSettings settings;
    settings.map_size = map_size;
    return settings;
}

/// The weighted, scaled matrix B whose products the solvers take, as SciPy reads it.
void dump_system(const std::filesystem::path& folder, const LogRows& left, const ChannelRows& right,
                 const WeightedSystem& system) {
    const Vector scale = system.scaled_unknowns(Vector(left.matrix.columns(), 1.0));
    std::vector<std::uint64_t> starts{0};
    std::vector<std::uint32_t> columns;
    std::vector<double> values;
    for (std::size_t i = 0; i < left.matrix.rows(); ++i) {
        for (const MatrixEntry& e : left.matrix.row(i)) {
            columns.push_back(e.column);
            values.push_back(right.weight[i] * e.value / scale[e.column]);
        }
        starts.push_back(columns.size());
    }
    const std::vector<std::uint64_t> width{left.matrix.columns()}, samples{left.samples};
    const Vector b = system.right_side();
    dump(folder / "starts", std::span<const std::uint64_t>(starts));
    dump(folder / "columns", std::span<const std::uint32_t>(columns));
    dump(folder / "values", std::span<const double>(values));
    dump(folder / "width", std::span<const std::uint64_t>(width));
    dump(folder / "samples", std::span<const std::uint64_t>(samples));
    dump(folder / "right_side", std::span<const double>(b));
}

/// Relative rms difference of the peer's sums from ours.
double difference(const std::vector<Rgb>& ours, const std::vector<double>& theirs) {
    double sum = 0.0, square = 0.0;
    for (std::size_t i = 0; i < ours.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double d = ours[i][c] - theirs.at(3 * i + static_cast<std::size_t>(c));
            sum += d * d;
            square += ours[i][c] * ours[i][c];
        }
    return std::sqrt(sum / square);
}

template <class T>
std::span<const double> as_doubles(const std::vector<T>& values) {
    return {&values[0].n.x, values.size() * sizeof(T) / sizeof(double)};
}

struct Fitted {
    double seconds = 0.0;
    FactoredLighting lighting;
};

Fitted timed_fit(const LightingSamples& samples, const FactorSettings& settings, int threads) {
    const double start = wall_seconds();
    FactoredLighting lighting = factorize(samples, cheap_samples(1000), settings, 1.0, threads);
    return {wall_seconds() - start, std::move(lighting)};
}

constexpr int batch_size = 1 << 16;

/// Seconds to place and fit samples that are made and dropped in batches.
double batched_fit(int count, const FactorSettings& settings) {
    FitSamples fit(settings, static_cast<std::size_t>(count));
    double seconds = 0.0;
    for (int first = 0; first < count; first += batch_size) {
        const LightingSamples batch = cheap_samples(std::min(batch_size, count - first), first);
        const double start = wall_seconds();
        fit.add(batch, 2);
        seconds += wall_seconds() - start;
    }
    const LightingSamples judged = cheap_samples(1000);
    const double start = wall_seconds();
    factorize(std::move(fit), judged, 1.0, 2);
    return seconds + wall_seconds() - start;
}

bool same_bytes(const FactorMap& a, const FactorMap& b) {
    for (std::size_t i = 0; i < a.bytes.size(); ++i)
        if (std::get<std::vector<Rgba8>>(a.bytes[i].texels) !=
            std::get<std::vector<Rgba8>>(b.bytes[i].texels))
            return false;
    return true;
}

FactorFigure speed_up(std::string work, double one, double two) {
    return {std::move(work), fmt::format("{:.3f} s, {:.3f} s", one, two), "", one / two, "x", 1.7,
            std::nullopt};
}

}  // namespace

std::vector<FactorFigure> measure_sampling(const Peer& peer) {
    const DistantLights lights = sky();
    const std::vector<SurfaceView> at = surface_views(sampled_views, 0);
    std::vector<double> table;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const Vec3 l = lights.direction(k);
        const Rgb w = lights.weight(k);
        table.insert(table.end(), {l.x, l.y, l.z, w.x, w.y, w.z});
    }
    dump(peer.folder / "lights", std::span<const double>(table));
    dump(peer.folder / "views", as_doubles(at));
    std::vector<Rgb> radiance;
    const FrameTimes ours =
        time_frames([&] { radiance = outgoing_radiance(material, lights, at, 1); }, 1.0, 3);
    const auto theirs = peer_seconds(peer, "radiance");
    if (theirs && difference(radiance, read_doubles(peer.folder / "radiance")) > 1e-9)
        throw Error(ExitCode::failure, "bench_factor: NumPy's sum is another");
    const double pairs = 1e-9 * light_count * static_cast<double>(at.size());
    return {against("L_o, Cook-Torrance: a sample and light", ours.cpu, theirs, pairs, "ns", 8.0)};
}

std::vector<FactorFigure> measure_solvers(const Peer& peer) {
    const FactorSettings settings;
    FitSamples fit(settings, static_cast<std::size_t>(settings.samples));
    fit.add(cheap_samples(settings.samples), 1);
    auto [left, radiance] = std::move(fit).parts();
    std::array<ChannelRows, 3> right;
    std::vector<WeightedSystem> systems;
    std::vector<const WeightedSystem*> together;
    systems.reserve(3);
    for (std::size_t c = 0; c < 3; ++c) {
        right[c] = channel_rows(left, std::move(radiance[c]), settings, 1.0);
        together.push_back(&systems.emplace_back(left, right[c], settings, 1));
    }
    dump_system(peer.folder, left, right[0], systems[0]);
    const StopRule rule{.tolerance = 0.0, .iteration_limit = iterations, .window = 0};
    const std::vector<Vector> start(3, Vector(left.matrix.columns(), 0.0));
    std::vector<FactorFigure> figures;
    for (const auto& [solver, name, least] :
         {std::tuple{Solver::lsmr, "lsmr", 5.0}, {Solver::qmr, "qmr", 8.0}}) {
        int taken = 0;
        Rounds drawn, ordered;
        for (int round = 0; round < 5; ++round) {
            const FrameTimes ours = time_frames(
                [&, solver = solver] {
                    taken = 0;
                    for (const Solution& s : solve_channels(solver, together, start, rule, 1))
                        taken += s.report.iterations;
                },
                0.5, 3);
            const std::string work = fmt::format("{} {}", name, iterations);
            drawn.add(ours.cpu / 3.0, peer_seconds(peer, work));
            ordered.add(ours.cpu / 3.0, peer_seconds(peer, work + " ordered"));
        }
        if (taken != 3 * iterations)
            throw Error(ExitCode::failure,
                        fmt::format("bench_factor: {} ended after {}", name, taken));
        figures.push_back(drawn.against_peer(
            fmt::format("{}: an iteration of a channel, {} samples", name, settings.samples),
            1e-3 * iterations, "ms", least));
        figures.push_back(ordered.against_peer("the same, SciPy's rows in our order",
                                               1e-3 * iterations, "ms", std::nullopt));
    }
    return figures;
}

std::vector<FactorFigure> measure_growth(int largest) {
    std::vector<FactorFigure> figures;
    FactorSettings settings = settings_of(32);
    settings.tolerance = 0.0;
    settings.iteration_limit = 10;
    double first = 0.0, memory = 0.0;
    for (int count = 100000; count <= largest; count *= 10) {
        const auto [seconds, peak] = in_own_process([&] {
            const double before = peak_mebibytes();
            const double taken = batched_fit(count, settings);
            return std::array{taken, peak_mebibytes() - before};
        });
        const double each = seconds / count;
        memory = peak;
        if (first == 0.0) first = each;
        figures.push_back({fmt::format("fit of {} samples, 10 iterations", count),
                           fmt::format("{:.3g} us a sample", 1e6 * each), "", each / first,
                           "of the first", std::nullopt, std::nullopt});
    }
    figures.push_back({fmt::format("memory of the fit of {} samples", largest),
                       fmt::format("{:.0f} MiB", memory), "", memory, "MiB", std::nullopt,
                       std::nullopt});
    if (largest == 10000000) figures.back().most = 512.0;
    return figures;
}

std::vector<FactorFigure> measure_threads() {
    const DistantLights lights = sky();
    const std::vector<SurfaceView> at = surface_views(sampled_views, 0);
    std::array<std::vector<Rgb>, 2> radiance;
    std::array<double, 2> sampling{}, fitting{};
    std::array<Fitted, 2> fitted;
    const LightingSamples samples = cheap_samples(fitted_samples);
    for (const std::size_t i : {0U, 1U}) {
        const int threads = static_cast<int>(i) + 1;
        sampling[i] =
            time_frames([&] { radiance[i] = outgoing_radiance(material, lights, at, threads); },
                        1.0, 5)
                .wall;
        fitting[i] =
            time_frames([&] { fitted[i] = timed_fit(samples, settings_of(32), threads); }, 1.0, 3)
                .wall;
    }
    const auto& a = fitted[0].lighting.terms[0];
    const auto& b = fitted[1].lighting.terms[0];
    if (radiance[0] != radiance[1] || !same_bytes(a.t1, b.t1) || !same_bytes(a.t2, b.t2))
        throw Error(ExitCode::failure, "bench_factor: two threads give other bytes than one");
    return {speed_up("L_o with two threads, the same bits", sampling[0], sampling[1]),
            speed_up("fit with two threads, the same bytes", fitting[0], fitting[1])};
}

std::vector<FactorFigure> measure_scene(const std::filesystem::path& scene) {
    const Scene read = read_scene(scene);
    const double start = wall_seconds();
    light_scene(read, 2, [](const std::string&) {});
    const double seconds = wall_seconds() - start;
    return {{fmt::format("factor step of {}, two threads", scene.filename().string()),
             fmt::format("{:.2f} s", seconds), "", seconds, "s", std::nullopt, 2.0}};
}

}  // namespace twofold::bench
