// Frames and their differences as pictures: 8-bit sRGB, row 0 = top row, width x height x 3.
#pragma once

#include "validate/metrics/frame_pair.h"
#include "validate/report/colors.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline {

struct Picture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;
};

/// The frame's R G B, sRGB-encoded, pixels that aren't finite in kInvalid; gray coverage if the frame has no
/// color.
Picture colorPicture(const Frame& frame);

/// Agree, missing, extra, another object.
Picture silhouettePicture(const FramePair& pair);

/// Signed error test - reference over shared pixels by colormap::kDiverging, its ends at +-range. `range` >
/// 0, world units.
Picture depthErrorPicture(const FramePair& pair, std::span<const float> referenceDepth,
                          std::span<const float> testDepth, double range);

/// cost.iterations over the test's covered pixels by colormap::kSequential, its end at `most` > 0.
Picture iterationsPicture(const Frame& test, double most);

/// A curvature channel over the test's covered pixels by colormap::kCurvature, its ends at +-range > 0, world
/// units^-1: red where the base is convex along the channel's direction, blue where it is concave.
Picture curvaturePicture(const Frame& test, const std::string& channel, double range);

/// |value| of the channel that 90 % of the covered pixels stay within, as edges and tips have many times the
/// curvature; 0 if none is finite.
double curvatureRange(const Frame& test, const std::string& channel);

/// Lit in both, dark in both, false shadow (kExtra), false light (kMissing) over shared pixels.
Picture shadowPicture(const FramePair& pair, const std::string& light);

} // namespace plumbline
