// The input of every metric: two frames of one view, its camera and its lights.
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
    std::string reason;       // why there is no depth
};

/// The frame's Z, or the depth of its P and the camera. `which`: "reference" or "test", for the reason.
PlanarDepth planarDepth(const Frame& frame, const char* which, const std::optional<Camera>& camera);

struct MetricInput {
    /// `lights`: those with a known direction or position. The frames must outlive the input. Throws
    /// InputError as FramePair does.
    MetricInput(const Frame& reference, const Frame& test, std::vector<ObjectInfo> objects,
                std::optional<Camera> camera, std::vector<Light> lights);

    /// Lights with a channel shadow.<light> in either frame, ascending.
    std::vector<std::string> lightNames() const;
    /// nullopt if its direction or position isn't known.
    std::optional<Light> light(const std::string& name) const;
    /// Why depths can't be compared; empty if both frames have one.
    const std::string& noDepthReason() const;

    FramePair pair;
    std::optional<Camera> camera;
    std::vector<Light> lights;
    PlanarDepth referenceDepth, testDepth;
};

} // namespace plumbline
