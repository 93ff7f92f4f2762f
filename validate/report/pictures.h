// Frames and their differences as images: 8-bit sRGB, row 0 = top row, width x height x 3.
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

/// The frame's R G B, sRGB-encoded; pixels that aren't finite have kInvalid. If the frame has no color, its
/// coverage in gray.
Picture colorPicture(const Frame& frame);

/// Pixels colored by whether they agree, are missing, extra, or show another object.
Picture silhouettePicture(const FramePair& pair);

/// Signed error test - reference at shared pixels, by colormap::kDiverging with its ends at +-range. `range`:
/// > 0, world units.
Picture depthErrorPicture(const FramePair& pair, std::span<const float> referenceDepth,
                          std::span<const float> testDepth, double range);

/// cost.iterations at the test's covered pixels, by colormap::kSequential with its end at `largest` > 0.
Picture iterationsPicture(const Frame& test, double largest);

/// A curvature channel at the test's covered pixels, by colormap::kCurvature with its ends at +-range > 0,
/// world units^-1: red where the base is convex along the channel's direction, blue where it is concave.
Picture curvaturePicture(const Frame& test, const std::string& channel, double range);

/// 90th percentile of |value| over the covered pixels, because edges and tips have many times the curvature
/// of the rest; 0 if no value is finite.
double curvatureRange(const Frame& test, const std::string& channel);

/// Shared pixels colored by whether they are lit in both, dark in both, falsely dark (kExtra) or falsely lit
/// (kMissing).
Picture shadowPicture(const FramePair& pair, const std::string& light);

} // namespace plumbline
