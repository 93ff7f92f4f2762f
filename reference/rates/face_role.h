// Classifies faces by their contribution to the image: visible, casting shadows, or none.
#pragma once

#include "scenes/scene/scene.h"
#include "scenes/surface/base_surface.h"

#include <vector>

namespace plumbline {

enum class FaceRole {
    Seen,  // may be visible
    Casts, // not visible, but its shadow may be
    Idle,  // neither
};

struct FacePlace {
    FaceRole role = FaceRole::Idle;
    double pixelsPerWorld = 0; // at its point nearest to the camera in the image; 0 unless seen
};

/// Classifies each face of one object by its bounding sphere, including the relief. Faces of a closed object
/// that are back-facing everywhere, by more than kBackFacingCosine, count as not seen, unless the relief is
/// displaced along an axis.
std::vector<FacePlace> placeFaces(const Scene& scene, const BaseSurface& surface, const Relief* relief);

} // namespace plumbline
