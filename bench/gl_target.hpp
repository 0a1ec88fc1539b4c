#pragma once
#include <GL/gl.h>

#include "raster/pass.hpp"

namespace twofold::bench {

/// A framebuffer object with the frame's size and depth, cleared as the frame says and bound for
/// drawing.
class GlTarget {
  public:
    explicit GlTarget(const Frame& frame);
    ~GlTarget();
    GlTarget(const GlTarget&) = delete;
    GlTarget& operator=(const GlTarget&) = delete;

    /// The picture so far, rows top down.
    ByteImage read() const;

  private:
    int width_, height_;
    GLuint framebuffer_ = 0, color_ = 0, depth_ = 0;
};

}  // namespace twofold::bench
