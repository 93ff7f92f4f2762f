// The float targets a frame is drawn into, and the way from there to a Frame.
#pragma once

#include "../scenes/frame.h"
#include "../scenes/scene.h"
#include "gl_context.h"
#include "gl_objects.h"

#include <string>
#include <vector>

namespace plumbline {

/// Draw buffers: four for the channels every frame has, the rest four lights each. 8 is what every driver
/// offers.
inline constexpr int kFixedTargets = 4, kMaxTargets = 8, kLightsPerTarget = 4;
inline constexpr int kMaxLights = (kMaxTargets - kFixedTargets) * kLightsPerTarget;

/// Number of draw buffers for so many lights.
inline int targetCount(size_t lightCount) {
    return kFixedTargets + (static_cast<int>(lightCount) + kLightsPerTarget - 1) / kLightsPerTarget;
}

class FrameTarget {
  public:
    /// Throws InputError for more than kMaxLights lights, MachineError if the GL can't hold the picture.
    FrameTarget(const Scene& scene, const GlContext& context);

    /// Binds the targets and clears them to a miss everywhere.
    void begin() const;
    /// Reads every channel back. `origin` is added to positions and, by object, `stOrigins` to st; `channels`
    /// (rows of the channel table) says which to keep, all if empty.
    Frame read(const Vec3& originWorld, const std::vector<Vec2>& stOrigins,
               const std::vector<std::string>& channels) const;

  private:
    std::vector<float> readTarget(int target) const;
    void readShadows(Frame& frame, const std::vector<float>& coverage) const;

    const Scene& scene_;
    int width_, height_, targets_;
    GlFramebuffer framebuffer_;
    std::vector<GlTexture> textures_;
    GlTexture depth_;
};

} // namespace plumbline
