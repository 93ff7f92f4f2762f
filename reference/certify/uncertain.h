// Pixels and shadows that the micro-triangles' own error could change.
//
// Let every point of the micro-triangles be moved by at most its grid's bound (MicroGrid::errorWorld): that
// is where the true surface may be. As long as a line of sight stays farther than that from every contour
// edge, the sheets it crosses remain the same ones (a sheet without folds over a disc, moved by less than the
// disc's radius, still covers its center). So what is seen through a pixel, or whether a light is, can change
// only within that distance of a contour where beyond it something else is seen.
#pragma once

#include "reference/certify/contours.h"
#include "reference/trace/embree_scene.h"
#include "scenes/scene/camera.h"
#include "scenes/scene/light.h"

#include <span>
#include <vector>

namespace plumbline {

/// `uncertain`: 1 where the object seen, or whether any is, could change. `otherSheet`: 1 where another part
/// of the surface could be seen, of the same object or not. Both are planes with a value a pixel, 0
/// everywhere before. `ids`: the frame's.
void markUncertainCoverage(const Camera& camera, const std::vector<ContourFinder>& contours,
                           const EmbreeScene& embree, std::span<const float> ids, std::span<float> uncertain,
                           std::span<float> otherSheet);

/// A point whose shadow was decided by a ray.
struct ShadowPoint {
    uint32_t pixel;
    Vec3 positionWorld;
    double shiftWorld; // its ray started so far from it
    bool shadow;
};

/// Fills `uncertain` for the points given.
void markUncertainShadow(const Light& light, const std::vector<ContourFinder>& contours,
                         const EmbreeScene& embree, const std::vector<ShadowPoint>& points,
                         std::span<float> uncertain);

} // namespace plumbline
