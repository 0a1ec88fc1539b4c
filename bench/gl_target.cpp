#include "bench/gl_target.hpp"

#include <GL/glext.h>

#include "texunit/error.hpp"

namespace twofold::bench {
namespace {

/// OpenGL's rows run bottom up, those of our pictures top down.
ByteImage flipped(const ByteImage& image) {
    ByteImage result{image.width, image.height, {}};
    result.pixels.reserve(image.pixels.size());
    for (std::ptrdiff_t y = image.height - 1; y >= 0; --y) {
        const auto row = image.pixels.begin() + y * image.width;
        result.pixels.insert(result.pixels.end(), row, row + image.width);
    }
    return result;
}

/// A texture rather than a renderbuffer, because it can be filled with the frame's initial colours.
GLuint make_color(const Frame& frame) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    const ByteImage initial = frame.initial_color ? flipped(*frame.initial_color) : ByteImage{};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, frame.width, frame.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, frame.initial_color ? initial.pixels.data() : nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
    return name;
}

GLuint make_depth(const Frame& frame) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER,
                          frame.depth_bits == 16 ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT24,
                          frame.width, frame.height);
    return name;
}

void clear(const Frame& frame) {
    const Vec4& c = frame.clear_color;
    glClearColor(static_cast<GLfloat>(c.x), static_cast<GLfloat>(c.y), static_cast<GLfloat>(c.z),
                 static_cast<GLfloat>(c.w));
    glClearDepth(frame.clear_depth);
    glClear(GL_DEPTH_BUFFER_BIT | (frame.initial_color ? 0U : GL_COLOR_BUFFER_BIT));
}

}  // namespace

GlTarget::GlTarget(const Frame& frame)
    : width_(frame.width), height_(frame.height), color_(make_color(frame)) {
    depth_ = make_depth(frame);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ExitCode::failure, "OpenGL: the framebuffer object is incomplete");
    glDrawBuffer(GL_COLOR_ATTACHMENT0);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glViewport(0, 0, width_, height_);
    clear(frame);
}

GlTarget::~GlTarget() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &depth_);
    glDeleteTextures(1, &color_);
}

ByteImage GlTarget::read() const {
    ByteImage image{width_, height_, {}};
    image.pixels.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return flipped(image);
}

}  // namespace twofold::bench
