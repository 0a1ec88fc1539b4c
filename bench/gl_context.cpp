#include "bench/gl_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <array>

#include "texunit/error.hpp"

namespace twofold::bench {
namespace {

bool initialised(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
}

/// Surfaceless is Mesa's platform without any device; the default display covers other drivers.
EGLDisplay open_display() {
    const EGLDisplay surfaceless =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (initialised(surfaceless)) return surfaceless;
    const EGLDisplay usual = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (initialised(usual)) return usual;
    throw Error(ExitCode::failure, "EGL: no display, neither surfaceless nor the default one");
}

EGLConfig choose_config(EGLDisplay display) {
    constexpr std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                           EGL_DONT_CARE, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) != EGL_TRUE || count == 0)
        throw Error(ExitCode::failure, "EGL: no configuration for desktop OpenGL");
    return config;
}

std::string gl_string(GLenum name) {
    const GLubyte* text = glGetString(name);
    std::string result;
    for (; text && *text != 0; ++text) result.push_back(static_cast<char>(*text));
    return result;
}

}  // namespace

GlContext::GlContext() : display_(open_display()), context_(EGL_NO_CONTEXT) {
    // Without attributes EGL asks for OpenGL 1.0, which Mesa meets with its compatibility profile.
    if (eglBindAPI(EGL_OPENGL_API) == EGL_TRUE)
        context_ = eglCreateContext(display_, choose_config(display_), EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT ||
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
        throw Error(ExitCode::failure, "EGL: no desktop OpenGL context without a surface");
}

GlContext::~GlContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

std::string GlContext::renderer() const { return gl_string(GL_RENDERER); }
std::string GlContext::version() const { return gl_string(GL_VERSION); }

}  // namespace twofold::bench
