#include "validate/cli/frame_memory.h"

#include "realtime/draw/target_bytes.h"
#include "scenes/core/free_memory.h"
#include "scenes/core/index.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

// Bytes a pixel. The reference has 15 channels of 4 bytes and two more for each light, the error of each
// pixel (4), and its evidence: 10 bytes and one for each light (reference/trace/render.h).
constexpr double kReference = 15 * 4 + 4 + 10, kReferenceLight = 2 * 4 + 1;
// A drawn frame has 20 channels or more and one for each light. Software renderers hold the render targets
// beside it, and their process and this one hold the frame.
constexpr double kFrame = 20 * 4, kFrameLight = 4;

double bytesPerPixel(FrameUse use, double lights) {
    const double reference = kReference + kReferenceLight * lights, frame = kFrame + kFrameLight * lights;
    switch (use) {
    case FrameUse::Reference:
        return reference;
    case FrameUse::Drawn:
        return 2 * frame + kTargetBytesPerPixel;
    case FrameUse::Compared:
        break;
    }
    return reference + 2 * frame + kTargetBytesPerPixel;
}

} // namespace

void requireFrameMemory(const Scene& scene, FrameUse use) {
    const int width = scene.camera.width, height = scene.camera.height;
    requireMemory(fmt::format("a frame of {} x {} pixels and {} lights", width, height, scene.lights.size()),
                  bytesPerPixel(use, static_cast<double>(scene.lights.size())) *
                      static_cast<double>(areaOf(width, height)));
}

} // namespace plumbline
