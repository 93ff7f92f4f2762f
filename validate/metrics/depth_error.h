// Depth error: how far in front of or behind the reference's surface that of the test lies.
//
// Domain: pixels that both frames cover with the same object of the selection, where both depths are finite.
// Per pixel
//     e = Z_test - Z_reference          planar depth (channel Z), world units; e > 0: the test is too far
//     bias = mean e,  MAE = mean |e|,  RMSE = sqrt(mean e^2),  percentiles and max of |e| (nearest rank, see
//     figure.h)
// Figures named ..Relief are the same of e / reliefDepth of the pixel's own object. BadPix t = share of the
// domain with |e| > t * reliefDepth (Scharstein and Szeliski 2002, "bad pixels", with the relief depth as the
// unit). Pixels that only one frame covers are counted separately, as are those where a depth isn't finite.
#pragma once

#include "validate/metrics/metric.h"

#include <span>

namespace plumbline {

struct DepthError {
    uint64_t domainPx = 0;
    uint64_t onlyReferencePx = 0, onlyTestPx = 0; // the silhouette's missing and extra
    uint64_t invalidPx = 0;                       // both cover it, but a depth is NaN or infinite
    Figure uncertainPx; // pixels of the domain marked in the reference's channel `uncertain`

    struct Spread {
        Figure bias, mae, rmse, p50, p95, p99, max;
    };
    Spread world;  // world units
    Spread relief; // shares of the relief depth
    uint64_t bad1pctPx = 0, bad5pctPx = 0, bad25pctPx = 0;
    Figure badpix1pct, badpix5pct, badpix25pct; // in [0, 1]
};

/// `referenceDepth`, `testDepth`: planar depth per pixel, world units (see planarDepth in metric_input.h), or
/// empty if a frame has none; every figure is then absent with `noDepthReason`.
DepthError computeDepthError(const FramePair& pair, ObjectSelection selection,
                             std::span<const float> referenceDepth, std::span<const float> testDepth,
                             const std::string& noDepthReason = {});

Metric depthErrorMetric();

} // namespace plumbline
