// Chooses a camera and a light for an unknown surface. World space.
#pragma once

#include "scenes/draft/surface_survey.h"
#include "scenes/scene/camera.h"

#include <string>

namespace plumbline {

/// Fraction of the image left empty on each side.
inline constexpr double kDraftMargin = 0.07;

/// Orthonormal view axes; right, up and -forward form a right-handed frame.
struct View {
    Vec3 forward, right, up;
};

/// Among views from all azimuths, 30 degrees above or below the horizon, the first that shows nearly as much
/// of the surface as the best one. The list begins with the view from the front and above. `reason` receives
/// a sentence for the scene file.
View chooseView(const SurfaceSurvey& survey, std::string& reason);

/// Chooses portrait format if the points are taller than wide, then places the camera as near as possible
/// such that it looks along `view` and the points stay inside the margin.
void frameWith(Camera& camera, const View& view, const std::vector<Vec3>& points);

/// Unit vector toward an oblique light: from the upper left of the image, or from the first other corner that
/// lights the visible surface well enough. `reason` receives a sentence for the scene file.
Vec3 chooseLight(const SurfaceSurvey& survey, const View& view, std::string& reason);

} // namespace plumbline
