#pragma once
#include "raster/pass.hpp"
#include "tests/raster/random/dice.hpp"

/// The parts of random frames; random_state puts them together.
namespace twofold::test {

/// Where a mesh's positions are given.
enum class Space { window, pixels, perspective };

/// A vertex in the window: pixels, and how far along the view it lies, 0 near to 1 far.
struct Spot {
    double x, y, depth;
};

/// What a mesh is seen by: passes that share it share these.
struct View {
    int width = 1;
    int height = 1;
    Space space = Space::window;
    Mat4 modelview{1.0};
    Mat4 projection{1.0};

    /// The position that is seen at the spot.
    Vec3 position_at(const Spot& spot) const;
};

View random_view(Dice& dice, int width, int height, Space space);

Vec3 random_direction(Dice& dice);
/// Each channel in [0, 1], often one of the ends.
Vec4 random_color(Dice& dice);

/// @param area about how many fragments the mesh may make
Mesh random_mesh(Dice& dice, const View& view, double area);
/// A grid over most of the window with smooth normals and coordinates: the paper's kind of mesh.
Mesh random_surface(Dice& dice, const View& view, double area);

Texture random_texture(Dice& dice);
/// A face of a paraboloid pair: random colours, alpha 1 within a disc and 0 outside.
Texture random_disc(Dice& dice, int size, double guard);

/// The nearest bytes.
Rgba8 byte_color(const Vec4& color);
std::vector<Rgba8> as_bytes(const std::vector<Rgba32f>& texels);

/// A unit that reads one of the textures (or none), as scene files allow it but for a few.
TextureUnitState random_unit(Dice& dice, const std::vector<Texture>& textures);
TexEnv random_env(Dice& dice);
RegisterCombiners random_combiners(Dice& dice, int most_stages);

/// A pass over the view's mesh with any state.
/// @param units how many texture units there are
PassState random_pass(Dice& dice, const View& view, const std::vector<Texture>& textures, int units,
                      int combiner_stages);
/// Changes one thing of a pass, or a few.
void disturb(Dice& dice, PassState& state, const View& view);

}  // namespace twofold::test
