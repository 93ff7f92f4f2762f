// Where a camera and a light stand for a surface nobody has looked at yet. World space.
#pragma once

#include "scenes/draft/surface_survey.h"
#include "scenes/scene/camera.h"

#include <string>

namespace plumbline {

/// Share of the picture left free on every side.
inline constexpr double kDraftMargin = 0.07;

/// Unit vectors at right angles, right-handed with -forward.
struct View {
    Vec3 forward, right, up;
};

/// Of views from all around, 30 degrees above or below the horizon, the first that shows nearly as much of
/// the surface as the best: from the front and above where that does. `reason`: a sentence.
View chooseView(const SurfaceSurvey& survey, std::string& reason);

/// Turns the picture upright for points that are taller than wide, and places the camera: the nearest that
/// looks along `view` and has them inside the margin.
void frameWith(Camera& camera, const View& view, const std::vector<Vec3>& points);

/// Unit vector toward a light aslant: from the upper left of the picture, or the first other corner that
/// lights what is seen. `reason`: a sentence.
Vec3 chooseLight(const SurfaceSurvey& survey, const View& view, std::string& reason);

} // namespace plumbline
