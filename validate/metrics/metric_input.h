// All that a metric gets to see: two frames of one view, its camera, and where its lights are.
#pragma once

#include "scenes/scene/camera.h"
#include "scenes/scene/light.h"
#include "validate/metrics/frame_pair.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// Planar depth of a frame.
struct PlanarDepth {
    std::vector<float> depth; // per pixel, world units; empty if there is none
    std::string reason;       // why there is none
};

/// The frame's Z, or depth from its P and the camera. `which`: "reference" or "test", for the reason.
PlanarDepth planarDepth(const Frame& frame, const char* which, const std::optional<Camera>& camera);

struct MetricInput {
    /// `lights`: those whose place is known. The frames must outlive the input. Throws InputError as
    /// FramePair does.
    MetricInput(const Frame& reference, const Frame& test, std::vector<ObjectInfo> objects,
                std::optional<Camera> camera, std::vector<Light> lights);

    /// Those with a channel shadow.<light> in either frame, ascending.
    std::vector<std::string> lightNames() const;
    /// nullopt where its place isn't known.
    std::optional<Light> light(const std::string& name) const;
    /// Empty if both frames have a depth.
    const std::string& noDepthReason() const;

    FramePair pair;
    std::optional<Camera> camera;
    std::vector<Light> lights;
    PlanarDepth referenceDepth, testDepth;
};

} // namespace plumbline
