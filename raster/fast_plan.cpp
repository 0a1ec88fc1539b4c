#include "raster/fast_plan.hpp"

#include "raster/frame_check.hpp"
#include "raster/lane_image.hpp"
#include "raster/vertex_stage.hpp"
#include "texunit/presets.hpp"

namespace twofold {
namespace {

template <NumericModel M>
std::vector<FastRoute> routes_of(const M& m, const Frame& frame, bool fuse) {
    std::vector<UploadedTexture<M>> textures;
    for (const Texture& t : frame.textures) textures.push_back(upload(m, t));
    const UploadedTexture<M> white = white_texture(m);
    std::vector<FastRoute> routes;
    const auto groups = group_passes(frame, fuse);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const GroupGeometry<M> geometry = group_geometry(m, frame, groups[g]);
        const std::string vertices = why_not_on_lanes(geometry, vertex_rule(m, geometry));
        for (const std::size_t p : groups[g].passes) {
            const PassState state = normalized(frame, frame.passes[p]);
            const BoundPass<M> bound = twofold::bind(m, state, frame.color_format, textures, white);
            const bool leads = p == groups[g].passes.front();
            routes.push_back(
                {vertices, why_not_on_lanes(bound), leads ? groups[g].apart : std::string{}, g});
        }
    }
    return routes;
}

}  // namespace

std::vector<FastRoute> fast_routes(const Frame& frame, Preset preset, const CustomSettings& custom,
                                   bool fuse) {
    check_frame(frame);
    return with_model(preset, custom, [&](const auto& m) { return routes_of(m, frame, fuse); });
}

}  // namespace twofold
