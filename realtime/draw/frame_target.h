// The float render targets of a frame, and their readback into a Frame.
#pragma once

#include "realtime/gl/gl_context.h"
#include "realtime/gl/gl_objects.h"
#include "realtime/technique/technique.h"
#include "scenes/frame/frame.h"
#include "scenes/scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace plumbline {

/// The limit of scene files. Shadows share one float with the flags of shaders/shading.glsl, one bit per
/// light; integers up to 2^24 are exact.
inline constexpr int kMaxLights = 16;

class FrameTarget {
  public:
    /// Throws InputError for more than kMaxLights lights, MachineError if the image exceeds GL's limits.
    FrameTarget(const Scene& scene, const GlContext& context);

    /// Binds the targets and clears all pixels to a miss.
    void begin() const;
    /// Marks the pixels whose nearest polygon is a back side, of those that `drawPolygons` draws with their
    /// depth. Leaves colors and depth as they are after begin().
    void markNearestBacks(const std::function<void()>& drawPolygons) const;
    /// Draws to the marked pixels only.
    void drawOnNearestBacks(const std::function<void()>& draw) const;
    /// Reads the channels back. `originWorld` is added to positions and, per object, `stOrigins` to st.
    /// The channels are those of the technique's manifest and the flags; curvature only for a curved base,
    /// faults only where there is a search.
    Frame read(const Vec3& originWorld, const std::vector<Vec2>& stOrigins, const Technique& technique) const;

  private:
    std::vector<float> readTarget(int target) const;

    const Scene& scene_;
    int width_, height_;
    GlFramebuffer framebuffer_;
    std::vector<GlTexture> textures_;
    GlTexture depth_;
};

} // namespace plumbline
