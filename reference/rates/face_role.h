// What the picture needs a face for: to be seen, to cast shadows into it, or nothing.
#pragma once

#include "scenes/scene/scene.h"
#include "scenes/surface/base_surface.h"

#include <vector>

namespace plumbline {

enum class FaceRole {
    Seen,  // may be in the picture, on the side the camera sees
    Casts, // not seen, but its shadow may be
    Idle,  // neither
};

struct FacePlace {
    FaceRole role = FaceRole::Idle;
    double pixelsPerWorld = 0; // at its nearest place to the camera that is in the picture; 0 unless seen
};

/// Per face of one object. Judged from spheres around the faces with all their relief can reach. A closed
/// object's faces that turn away from the camera everywhere, by more than kTurnedAway, count as not seen,
/// unless its relief goes along an axis.
std::vector<FacePlace> placeFaces(const Scene& scene, const BaseSurface& surface, const Relief* relief);

} // namespace plumbline
