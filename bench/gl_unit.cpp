#include "bench/gl_unit.hpp"

#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "bench/gl_enums.hpp"
#include "texunit/error.hpp"

namespace twofold::bench {
namespace {

[[noreturn]] void refuse(const char* what) {
    throw Error(ExitCode::failure, std::string("OpenGL comparison: ") + what);
}

std::array<GLfloat, 4> floats(const Vec4& v) {
    return {static_cast<GLfloat>(v.x), static_cast<GLfloat>(v.y), static_cast<GLfloat>(v.z),
            static_cast<GLfloat>(v.w)};
}

/// glTexParameteri, glTexEnvi and glTexGeni take enumerators as integers.
GLint as_int(GLenum e) { return static_cast<GLint>(e); }

struct Level {
    int number, border;
};

template <class Image>
void upload(GLenum target, const Level& level, const Image& image, BaseFormat format) {
    const auto send = [&](GLenum type, const void* data) {
        const bool real = type == GL_FLOAT;
        glTexImage2D(target, level.number, as_int(gl(format, real)), image.width, image.height,
                     level.border, GL_RGBA, type, data);
    };
    if (const auto* bytes = std::get_if<std::vector<Rgba8>>(&image.texels))
        send(GL_UNSIGNED_BYTE, bytes->data());
    else if (const auto* real = std::get_if<std::vector<Rgba32f>>(&image.texels))
        send(GL_FLOAT, real->data());
    else
        refuse("packed texels have no row here");
}

/// An image, then its mipmaps.
template <class Image>
void upload_levels(GLenum target, const Texture& texture, const Image& base) {
    int number = 0;
    upload(target, {number, texture.border}, base, texture.base_format);
    for (const TextureImage& image : base.mipmaps)
        upload(target, {++number, texture.border}, image, texture.base_format);
}

void upload_images(const Texture& texture, TextureTarget target) {
    const bool cube = target == TextureTarget::cube_map;
    GLenum face = cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : gl(target);
    upload_levels(face, texture, texture);
    if (!cube) return;
    for (const TextureFace& image : texture.cube_faces) upload_levels(++face, texture, image);
}

void set_sampling(const TextureUnitState& unit, std::size_t mipmaps) {
    const GLenum target = gl(unit.target);
    const bool rectangle = unit.target == TextureTarget::rectangle;
    const MipFilter mip = rectangle ? MipFilter::off : unit.mip_filter;
    glTexParameteri(target, GL_TEXTURE_WRAP_S, as_int(gl(unit.wrap_s)));
    glTexParameteri(target, GL_TEXTURE_WRAP_T, as_int(gl(unit.wrap_t)));
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, as_int(gl_min_filter(unit.min_filter, mip)));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, as_int(gl_mag_filter(unit.mag_filter)));
    if (!rectangle) glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(mipmaps));
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, floats(unit.border_color).data());
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, static_cast<GLfloat>(unit.lod_bias));
}

/// Modes that make a vector have no q, and SPHERE_MAP no r: OpenGL refuses them there.
bool allowed(TexGen mode, std::size_t coordinate) {
    if (mode == TexGen::sphere_map) return coordinate < 2;
    return coordinate < 3 || mode == TexGen::object_linear || mode == TexGen::eye_linear;
}

void set_texgen(const TexGenState& texgen) {
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    for (std::size_t i = 0; i < 4; ++i) {
        const TexGen mode = texgen.mode[i];
        if (mode == TexGen::none || !allowed(mode, i)) continue;
        const GLenum coordinate = GL_S + static_cast<GLenum>(i);
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, as_int(gl(mode)));
        glTexGendv(coordinate, GL_OBJECT_PLANE, glm::value_ptr(texgen.object_plane[i]));
        glTexGendv(coordinate, GL_EYE_PLANE, glm::value_ptr(texgen.eye_plane[i]));
        glEnable(GL_TEXTURE_GEN_S + static_cast<GLenum>(i));
    }
}

void env(GLenum name, GLenum value) { glTexEnvi(GL_TEXTURE_ENV, name, as_int(value)); }

void set_combine(const TexEnv& e) {
    env(GL_TEXTURE_ENV_MODE, GL_COMBINE);
    env(GL_COMBINE_RGB, gl(e.combine_rgb));
    env(GL_COMBINE_ALPHA, gl(e.combine_alpha));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto n = static_cast<GLenum>(i);
        env(GL_SRC0_RGB + n, gl(e.rgb[i].source));
        env(GL_OPERAND0_RGB + n, gl(e.rgb[i].operand));
        env(GL_SRC0_ALPHA + n, gl(e.alpha[i].source));
        env(GL_OPERAND0_ALPHA + n, gl(e.alpha[i].operand));
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, e.rgb_scale);
    glTexEnvi(GL_TEXTURE_ENV, GL_ALPHA_SCALE, e.alpha_scale);
}

/// MODULATE with a scale is our shorthand for COMBINE with its initial arguments; with RGBA the two
/// are the same.
void set_environment(const TexEnv& e, BaseFormat format) {
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, floats(e.color).data());
    const bool scaled = e.rgb_scale != 1 || e.alpha_scale != 1;
    if (e.mode == TexEnvMode::combine) {
        set_combine(e);
    } else if (e.mode == TexEnvMode::modulate && scaled) {
        if (format != BaseFormat::rgba) refuse("a scaled MODULATE of another format than RGBA");
        TexEnv combine;
        combine.rgb_scale = e.rgb_scale;
        combine.alpha_scale = e.alpha_scale;
        set_combine(combine);
    } else {
        env(GL_TEXTURE_ENV_MODE, gl(e.mode));
    }
}

}  // namespace

GlTexture::GlTexture(const Texture& texture, const TextureUnitState& unit) {
    glGenTextures(1, &name_);
    glBindTexture(gl(unit.target), name_);
    upload_images(texture, unit.target);
    set_sampling(unit, texture.mipmaps.size());
    glEnable(gl(unit.target));
}

GlTexture::~GlTexture() {
    if (name_ != 0) glDeleteTextures(1, &name_);
}

GlTexture::GlTexture(GlTexture&& other) noexcept : name_(std::exchange(other.name_, 0)) {}

void set_unit(const TextureUnitState& unit, BaseFormat format) {
    if (!unit.divide_by_q) refuse("OpenGL always divides by q");
    set_texgen(unit.texgen);
    glMatrixMode(GL_TEXTURE);
    glLoadMatrixd(glm::value_ptr(unit.matrix));
    set_environment(unit.env, format);
}

}  // namespace twofold::bench
