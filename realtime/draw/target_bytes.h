// Memory of the render targets of a frame (frame_target.h). No OpenGL, for runs that check it before they
// draw.
#pragma once

namespace plumbline {

inline constexpr int kColorTargets = 5; // RGBA32F, 16 bytes a pixel; the depth's DEPTH32F_STENCIL8 takes 8
inline constexpr double kTargetBytesPerPixel = kColorTargets * 16 + 8;

} // namespace plumbline
