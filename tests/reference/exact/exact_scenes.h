// Difficult scenes with one flat relief: spikes, grazing views, grazing light, tiles that aren't aligned with
// grids.
#pragma once

#include "scenes/scene/scene.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace plumbline {

struct ExactScene {
    std::string name;
    Scene scene;
    int fineRate; // segments per control edge, at most a third of a texel each
};

/// The name of a scene in googletest's output.
void PrintTo(const ExactScene& scene, std::ostream* stream);

std::vector<ExactScene> exactScenes();

} // namespace plumbline
