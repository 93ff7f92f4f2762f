// Depth errors of a technique as curves: the share of pixels with an error above a threshold, as a function
// of the threshold, and the histogram of signed errors. In relief depths, over the domain of the pooled depth
// figures (validate/metrics/depth_error.h).
#pragma once

#include "validate/compare/compare.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace plumbline::report {

/// Thresholds of the figures badpix_1pct, 5pct, 25pct (Scharstein, Szeliski 2002).
inline constexpr std::array<double, 3> kNamedThresholds{0.01, 0.05, 0.25};
/// From 1e-4 to 10 relief depths, eight per decade, and the named ones.
std::vector<double> badpixThresholds();
/// From -0.25 to 0.25 relief depths in steps of 0.01.
std::vector<double> histogramEdges();

struct ErrorCurves {
    std::vector<double> badpix; // share with |e| > badpixThresholds()[i], strictly
    /// counts[i]: pixels with histogramEdges()[i] <= e < histogramEdges()[i + 1]; below and above: pixels
    /// beyond the ends.
    std::vector<uint64_t> counts;
    uint64_t below = 0, above = 0;
};

/// `comparison` must be of this pair. nullopt if the pooled depth figures in relief depths are absent.
std::optional<ErrorCurves> errorCurves(const FramePair& pair, const Comparison& comparison);

} // namespace plumbline::report
