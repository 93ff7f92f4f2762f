// Scenes of one flat relief, each hard in a way of its own: spikes, grazing views, grazing light, tiles that
// fit no grid.
#pragma once

#include "scenes/scene/scene.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace plumbline {

struct ExactScene {
    std::string name;
    Scene scene;
    int fineRate; // segments per control edge: a third of a texel or less
};

/// How googletest names a scene.
void PrintTo(const ExactScene& scene, std::ostream* stream);

std::vector<ExactScene> exactScenes();

} // namespace plumbline
