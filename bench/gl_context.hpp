#pragma once
#include <string>

/// An OpenGL of the compatibility profile without a window, made by EGL.
namespace twofold::bench {

/// A current context; drawing goes to framebuffer objects. One at a time.
class GlContext {
  public:
    /// @throws Error if no EGL display offers a desktop OpenGL context without a surface
    GlContext();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// GL_RENDERER and GL_VERSION, as the driver words them.
    std::string renderer() const;
    std::string version() const;

  private:
    void* display_;  ///< an EGLDisplay; EGL's headers stay out of this one
    void* context_;  ///< an EGLContext
};

}  // namespace twofold::bench
