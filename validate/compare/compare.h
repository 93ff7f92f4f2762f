// Two frames to every metric, per object and pooled over the objects with a relief.
#pragma once

#include "scenes/scene/camera.h"
#include "validate/metrics/boundary_iou.h"
#include "validate/metrics/contour_distance.h"
#include "validate/metrics/depth_error.h"
#include "validate/metrics/fetch_cost.h"
#include "validate/metrics/image_error.h"
#include "validate/metrics/normal_angle.h"
#include "validate/metrics/search_iterations.h"
#include "validate/metrics/shadow_agreement.h"
#include "validate/metrics/shadow_kinds.h"
#include "validate/metrics/silhouette_iou.h"
#include "validate/metrics/st_error.h"

#include <map>
#include <optional>

namespace plumbline {

/// Every metric over one selection of objects: all but that of the whole picture.
struct MetricSet {
    SilhouetteIou silhouette;
    BoundaryIou boundary;
    ContourDistance contour;
    DepthError depth;
    std::map<std::string, ShadowAgreement> shadow;  // by light
    std::map<std::string, ShadowKinds> shadowKinds; // of the same lights
    NormalAngle normal;
    StError st;
    FetchCost cost;
    SearchIterations iterations;
};

struct ObjectComparison {
    ObjectInfo object;
    MetricSet metrics;
};

struct Comparison {
    MetricSet pooled;
    ImageError image;                       // of the whole picture
    std::vector<ObjectComparison> objects;  // in the order of the scene
    std::vector<std::string> pooledObjects; // names of those pooled
    std::vector<std::string> notes;         // what is missing, and what that rules out; a sentence each
    /// Planar depth of both frames as compared; empty where there is none.
    std::vector<float> referenceDepth, testDepth;
};

/// Planar depth of a frame: its Z, or from P and the camera. nullopt with a reason if neither is possible.
struct PlanarDepth {
    std::vector<float> depth; // per pixel, world units; empty if there is none
    std::string reason;       // why there is none
};
PlanarDepth planarDepth(const Frame& frame, const char* which, const std::optional<Camera>& camera);

/// `camera`: of the view, to get depth from positions where a frame has P but no Z, and to tell which side of
/// a surface it sees. Where the lights are stands in the reference's header or else the test's
/// (lightsFromHeader in frame_metadata.h). Throws InputError as FramePair and lightsFromHeader do.
Comparison compareFrames(const Frame& reference, const Frame& test, const std::vector<ObjectInfo>& objects,
                         const std::optional<Camera>& camera);

} // namespace plumbline
