#include "bench/gl_frame.hpp"

#include <fmt/format.h>

#include <glm/gtc/type_ptr.hpp>

#include "bench/gl_enums.hpp"
#include "bench/gl_target.hpp"
#include "bench/gl_unit.hpp"
#include "texunit/error.hpp"

namespace twofold::bench {
namespace {

void require(bool condition, const char* what) {
    if (!condition)
        throw Error(ExitCode::failure, fmt::format("OpenGL comparison: {} is not drawn", what));
}

void check_drawable(const PassState& s) {
    require(!s.viewport, "a viewport of its own");
    require(!s.window_space, "a mesh in window space");
    require(s.perspective_correction, "a pass without perspective correction");
    require(!s.combiners, "a pass with register combiners");
    require(!s.dither, "a dithered pass");
}

void enable(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

void set_matrices(const PassState& s) {
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(glm::value_ptr(s.projection));
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(glm::value_ptr(s.modelview));
    enable(GL_NORMALIZE, s.normalize);
}

void set_rasterization(const PassState& s, int height) {
    enable(GL_CULL_FACE, s.cull != CullFace::none);
    glCullFace(s.cull == CullFace::front ? GL_FRONT : GL_BACK);
    glShadeModel(s.shade_model == ShadeModel::flat ? GL_FLAT : GL_SMOOTH);
    glProvokingVertex(s.provoking_vertex == ProvokingVertex::first ? GL_FIRST_VERTEX_CONVENTION
                                                                   : GL_LAST_VERTEX_CONVENTION);
    enable(GL_SCISSOR_TEST, s.scissor.has_value());
    if (const auto& c = s.scissor) glScissor(c->x, height - c->y - c->height, c->width, c->height);
    enable(GL_COLOR_SUM, s.color_sum);
}

void set_fog(const std::optional<Fog>& fog) {
    enable(GL_FOG, fog.has_value());
    if (!fog) return;
    const std::array<GLfloat, 4> color{static_cast<GLfloat>(fog->color.x),
                                       static_cast<GLfloat>(fog->color.y),
                                       static_cast<GLfloat>(fog->color.z), 0.0F};
    glFogi(GL_FOG_MODE, static_cast<GLint>(gl(fog->mode)));
    glFogf(GL_FOG_DENSITY, static_cast<GLfloat>(fog->density));
    glFogf(GL_FOG_START, static_cast<GLfloat>(fog->start));
    glFogf(GL_FOG_END, static_cast<GLfloat>(fog->end));
    glFogfv(GL_FOG_COLOR, color.data());
}

void set_blend(const std::optional<Blend>& blend) {
    enable(GL_BLEND, blend.has_value());
    if (!blend) return;
    const Vec4& c = blend->color;
    glBlendFunc(gl(blend->source), gl(blend->destination));
    glBlendEquation(gl(blend->equation));
    glBlendColor(static_cast<GLfloat>(c.x), static_cast<GLfloat>(c.y), static_cast<GLfloat>(c.z),
                 static_cast<GLfloat>(c.w));
}

/// OpenGL dithers unless told not to.
void set_fragment_operations(const PassState& s) {
    glDisable(GL_DITHER);
    enable(GL_ALPHA_TEST, s.alpha_test.has_value());
    if (s.alpha_test)
        glAlphaFunc(gl(s.alpha_test->func), static_cast<GLfloat>(s.alpha_test->reference));
    enable(GL_DEPTH_TEST, s.depth_test.has_value());
    if (s.depth_test) {
        glDepthFunc(gl(s.depth_test->func));
        glDepthMask(s.depth_test->write ? GL_TRUE : GL_FALSE);
    }
    set_blend(s.blend);
    const auto& mask = s.color_mask;
    glColorMask(mask[0], mask[1], mask[2], mask[3]);
}

/// A unit that is on without a texture reads white, as ours does; OpenGL would switch it off.
const Texture& white() {
    static const Texture texture{1, 1, std::vector<Rgba8>{{255, 255, 255, 255}}};
    return texture;
}

/// The textures live until they are drawn with.
std::vector<GlTexture> set_units(const PassState& s, const std::vector<Texture>& textures) {
    std::vector<GlTexture> bound;
    for (std::size_t u = 0; u < max_units; ++u) {
        if (!s.units[u]) continue;
        const TextureUnitState& unit = *s.units[u];
        const Texture& texture = unit.texture ? textures[*unit.texture] : white();
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(u));
        bound.emplace_back(texture, unit);
        set_unit(unit, texture.base_format);
    }
    return bound;
}

std::vector<Vec4> homogeneous(const Mesh& mesh) {
    std::vector<Vec4> result;
    result.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        result.emplace_back(mesh.positions[i], mesh.position_w.empty() ? 1.0 : mesh.position_w[i]);
    return result;
}

void set_texcoords(const PassState& s, const Mesh& mesh) {
    for (std::size_t u = 0; u < max_units; ++u) {
        const auto& coords = mesh.texcoords[u].empty() ? mesh.texcoords[0] : mesh.texcoords[u];
        if (!s.units[u] || coords.empty()) continue;
        glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(u));
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(4, GL_DOUBLE, sizeof(Vec4), coords.data());
    }
}

void set_colors(const PassState& s, const Mesh& mesh) {
    glColor4dv(glm::value_ptr(s.color));
    if (!mesh.colors.empty()) {
        glEnableClientState(GL_COLOR_ARRAY);
        glColorPointer(4, GL_DOUBLE, sizeof(Vec4), mesh.colors.data());
    }
    glSecondaryColor3d(0.0, 0.0, 0.0);
    if (!mesh.secondary_colors.empty()) {
        glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
        glSecondaryColorPointer(3, GL_DOUBLE, sizeof(Vec4), mesh.secondary_colors.data());
    }
}

void draw_mesh(const PassState& s, const Mesh& mesh) {
    const std::vector<Vec4> positions = homogeneous(mesh);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(4, GL_DOUBLE, sizeof(Vec4), positions.data());
    if (!mesh.normals.empty()) {
        glEnableClientState(GL_NORMAL_ARRAY);
        glNormalPointer(GL_DOUBLE, sizeof(Vec3), mesh.normals.data());
    }
    set_texcoords(s, mesh);
    set_colors(s, mesh);
    glDrawElements(gl(mesh.primitive), static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT,
                   mesh.indices.data());
    glPopClientAttrib();
}

/// Every pass starts from OpenGL's initial state and leaves it behind.
void draw_pass(const Frame& frame, const Pass& pass) {
    check_drawable(pass.state);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    const std::vector<GlTexture> textures = set_units(pass.state, frame.textures);
    set_matrices(pass.state);
    set_rasterization(pass.state, frame.height);
    set_fog(pass.state.fog);
    set_fragment_operations(pass.state);
    draw_mesh(pass.state, frame.meshes[pass.mesh]);
    glPopAttrib();
}

}  // namespace

ByteImage draw_with_gl(const Frame& frame) {
    require(frame.color_format == ColorFormat::rgba8888, "16-bit or alpha-less colour");
    const GlTarget target(frame);
    for (const Pass& pass : frame.passes) draw_pass(frame, pass);
    ByteImage picture = target.read();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw Error(ExitCode::failure, fmt::format("OpenGL reports error {:#06x}", error));
    return picture;
}

}  // namespace twofold::bench
