// The float targets a frame is drawn into, and the way from there to a Frame.
#pragma once

#include "realtime/gl/gl_context.h"
#include "realtime/gl/gl_objects.h"
#include "scenes/frame/frame.h"
#include "scenes/scene/scene.h"

#include <string>
#include <vector>

namespace plumbline {

/// As many as a scene file may have. Shadows share one float, a bit a light: whole numbers up to 2^24 are
/// exact.
inline constexpr int kMaxLights = 16;

class FrameTarget {
  public:
    /// Throws InputError for more than kMaxLights lights, MachineError if the GL can't hold the picture.
    FrameTarget(const Scene& scene, const GlContext& context);

    /// Binds the targets and clears them to a miss everywhere.
    void begin() const;
    /// Reads every channel back. `origin` is added to positions and, by object, `stOrigins` to st; `channels`
    /// (rows of the channel table) says which to keep, all if empty; those of the curvature are there for a
    /// base that bends.
    Frame read(const Vec3& originWorld, const std::vector<Vec2>& stOrigins,
               const std::vector<std::string>& channels, bool curvedBase) const;

  private:
    std::vector<float> readTarget(int target) const;

    const Scene& scene_;
    int width_, height_;
    GlFramebuffer framebuffer_;
    std::vector<GlTexture> textures_;
    GlTexture depth_;
};

} // namespace plumbline
