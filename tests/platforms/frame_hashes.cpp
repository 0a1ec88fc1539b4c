#include "raster/fast.hpp"
#include "raster/reference.hpp"
#include "tests/platforms/named_hash.hpp"
#include "tests/raster/random/random_state.hpp"

/// Whole random frames by both pipelines, some of every preset.
namespace twofold::platforms {
namespace {

constexpr std::uint64_t seed = 7, states = 7 * 24;

void feed_mesh(Fnv1a& hash, const Mesh& mesh) {
    feed(hash, mesh.positions);
    feed(hash, mesh.normals);
    feed(hash, mesh.texcoords);
    feed(hash, mesh.colors);
    feed(hash, mesh.secondary_colors);
    feed(hash, mesh.indices);
}

/// Of what is drawn: differs where the generator of the states does.
NamedHash input_hash(const std::string& name, const Frame& frame) {
    Fnv1a hash;
    for (const Mesh& mesh : frame.meshes) feed_mesh(hash, mesh);
    return {"input/" + name, hash.value()};
}

void feed_counters(Fnv1a& hash, const DrawCounters& c) {
    feed(hash, std::array{c.triangles, c.rejected, c.not_finite, c.clipped, c.culled, c.zero_area,
                          c.set_up, c.fragments, c.undefined_coords, c.alpha_failed, c.depth_failed,
                          c.written});
}

NamedHash picture_hash(std::string name, const Framebuffer& picture) {
    Fnv1a hash;
    hash.u32(static_cast<std::uint32_t>(picture.width))
        .u32(static_cast<std::uint32_t>(picture.height))
        .u32(4);
    feed(hash, picture.bytes);
    feed(hash, picture.values);
    return {std::move(name), hash.value()};
}

/// Nothing of a state that no pipeline draws: there is none among these.
Hashes state_hashes(std::uint64_t number, int threads) {
    const test::RandomState state = test::random_state(seed, number);
    const std::string name = fmt::format("{}/state-{}", name_of(state.preset), number);
    const Framebuffer expected = render_reference(state.frame, state.preset, state.custom);
    const Framebuffer found =
        render_fast(state.frame, state.preset, state.custom, {threads, state.options.fuse});
    Fnv1a counters;
    feed_counters(counters, expected.counters);
    return {input_hash(name, state.frame),
            {"counters/" + name, counters.value()},
            picture_hash("reference/" + name, expected),
            picture_hash("fast/" + name, found)};
}

}  // namespace

Hashes frame_hashes(int threads) {
    Hashes hashes;
    for (std::uint64_t number = 0; number < states; ++number)
        append(hashes, state_hashes(number, threads));
    return hashes;
}

}  // namespace twofold::platforms
