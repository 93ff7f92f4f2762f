// Shadow, attached and cast apart: where the surface turns away from the light, and where something else is
// in its way.
//
// A technique that shades by a wrong normal gets the one wrong, one whose shadow rays miss gets the other.
// The domain is that of shadow_agreement.h, cut in two by the reference alone. With N its normal (N.X N.Y
// N.Z), turned to the side that the camera sees, and L the direction from its point to the light:
//     attached   N . L <= 0    the truth is dark, whatever is in the way
//     cast       N . L > 0     the truth is dark only where something is in the way: every shadow here is
//     cast
// Both frames are counted in both parts: agreement, false shadow, false lit. The parts make up the domain,
// but for pixels at which the reference has no normal. Needs the camera, and of the light its direction or
// place; for a place also P.X P.Y P.Z of the reference.
//
// There is no interval: what the reference leaves open of N . L isn't in its channels. The reference decides
// with the side that the facet it hit turns to the camera; at an outline, where N may turn away on a facet
// that doesn't, a few pixels differ.
#pragma once

#include "scenes/scene/camera.h"
#include "scenes/scene/light.h"
#include "validate/metrics/metric.h"

#include <optional>
#include <string>

namespace plumbline {

struct ShadowKinds {
    struct Part {
        Figure domainPx, falseShadowPx, falseLitPx; // whole numbers
        Figure agreement;                           // in [0, 1]
    };
    Part attached, cast;
    Figure noNormalPx; // of the domain, in neither part
};

/// `name`: of the light. All figures are absent where `light`, `camera` or a channel is missing.
ShadowKinds computeShadowKinds(const FramePair& pair, ObjectSelection selection, const std::string& name,
                               const std::optional<Light>& light, const std::optional<Camera>& camera);

Metric shadowKindsMetric();

} // namespace plumbline
