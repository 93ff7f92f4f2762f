// Attached and cast shadows, evaluated separately: an attached shadow is where the surface faces away from
// the light, a cast shadow where an occluder blocks the light.
//
// Wrong normals cause errors of attached shadows, shadow rays that miss cause errors of cast shadows. The
// domain of shadow_agreement.h is divided by the reference alone. With N its normal (N.X N.Y N.Z), turned
// toward the camera, and L the direction from its point to the light:
//     attached   N . L <= 0    the true image is dark, with or without an occluder
//     cast       N . L > 0     the true image is dark only if there is an occluder: every shadow is cast
// Agreement, false shadow and false lit are computed for each part. The parts make up the domain except for
// pixels at which the reference has no normal. Needs the camera and the direction or position of the light;
// for a position also P.X P.Y P.Z of the reference.
//
// There is no interval, because no channel contains the uncertainty of N . L. The reference itself decides by
// the side of the hit facet that faces the camera. At an outline N may face away while the facet doesn't, so
// a few pixels are classified differently there.
#pragma once

#include "scenes/scene/camera.h"
#include "scenes/scene/light.h"
#include "validate/metrics/metric.h"

#include <optional>
#include <string>

namespace plumbline {

struct ShadowKinds {
    struct Part {
        Figure domainPx, falseShadowPx, falseLitPx; // integers
        Figure agreement;                           // in [0, 1]
    };
    Part attached, cast;
    Figure noNormalPx; // pixels of the domain in neither part
};

/// `name`: of the light. All figures are absent if `light`, `camera` or a channel is missing.
ShadowKinds computeShadowKinds(const FramePair& pair, ObjectSelection selection, const std::string& name,
                               const std::optional<Light>& light, const std::optional<Camera>& camera);

Metric shadowKindsMetric();

} // namespace plumbline
