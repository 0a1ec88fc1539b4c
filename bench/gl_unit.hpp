#pragma once
#include <GL/gl.h>

#include "texunit/texture.hpp"
#include "texunit/unit_state.hpp"

/// A texture unit of a pass, told to OpenGL.
namespace twofold::bench {

/// A texture object, uploaded for one unit of one pass: OpenGL keeps wraps and filters with the
/// texture, so that sharing one between units would mix their states.
class GlTexture {
  public:
    /// Leaves the texture bound to the active unit.
    /// @throws Error for packed texels, which are not compared
    GlTexture(const Texture& texture, const TextureUnitState& unit);
    ~GlTexture();
    GlTexture(GlTexture&& other) noexcept;
    GlTexture& operator=(GlTexture&&) = delete;

  private:
    GLuint name_ = 0;
};

/// Everything but the texture: coordinate generation, texture matrix, environment. The unit must be
/// active. Loads the identity as modelview, because our eye planes are in eye coordinates already
/// and OpenGL takes them through the modelview of the moment.
/// @throws Error for what OpenGL cannot say
void set_unit(const TextureUnitState& unit, BaseFormat format);

}  // namespace twofold::bench
