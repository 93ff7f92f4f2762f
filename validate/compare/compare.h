// Two frames to every metric, per object and pooled over the objects with a relief.
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
    MetricSet pooled;                       // and of the whole picture
    std::vector<ObjectComparison> objects;  // in the order of the scene
    std::vector<std::string> pooledObjects; // names of those pooled
    std::vector<std::string> notes;         // what is missing, and what that rules out; a sentence each
    /// Planar depth of both frames as compared; empty where there is none.
    std::vector<float> referenceDepth, testDepth;
};

/// `camera`: of the view, to get depth from positions where a frame has P but no Z, and to tell which side of
/// a surface it sees. Where the lights are stands in the reference's header or else the test's
/// (lightsFromHeader in scenes/frame/frame_header.h). Throws InputError as FramePair and lightsFromHeader do.
Comparison compareFrames(const Frame& reference, const Frame& test, const std::vector<ObjectInfo>& objects,
                         const std::optional<Camera>& camera);

} // namespace plumbline
