// Computes every metric of two frames, per object and pooled over the objects with a relief.
#pragma once

#include "scenes/scene/camera.h"
#include "validate/metrics/metric_set.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

struct ObjectComparison {
    ObjectInfo object;
    MetricSet metrics;
};

struct Comparison {
    MetricSet pooled;                       // including those of the whole image
    std::vector<ObjectComparison> objects;  // in the order of the scene
    std::vector<std::string> pooledObjects; // names of the pooled objects
    std::vector<std::string> notes; // what is missing and which figures need it, and faults; a sentence each
    /// Planar depths that were compared; empty if a frame has none.
    std::vector<float> referenceDepth, testDepth;
};

/// `camera`: of the view; gives the depth of positions if a frame has P but no Z, and the visible side of a
/// surface. Lights are read from the reference's header, those missing there from the test's
/// (lightsFromHeader in scenes/frame/frame_header.h). Throws InputError as FramePair and lightsFromHeader do.
Comparison compareFrames(const Frame& reference, const Frame& test, const std::vector<ObjectInfo>& objects,
                         const std::optional<Camera>& camera);

} // namespace plumbline
