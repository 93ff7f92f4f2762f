// A first scene for a mesh and a height map that somebody brings: where the camera and the light stand, how
// deep the relief is and how often the map repeats. Every choice comes with its reason, for the comments of
// the scene file.
#pragma once

#include "scenes/scene/scene.h"

#include <filesystem>

namespace plumbline {

/// What isn't to be chosen.
struct DraftWishes {
    std::optional<Scheme> scheme;
    std::optional<double> depth; // world units, 0 to kLargestLength
    std::optional<Vec2> tile;    // no component 0
};

struct SceneDraft {
    Camera camera;
    Vec3 toLight{0, 1, 0};
    Vec3 translate{0, 0, 0}; // world units
    Scheme scheme = Scheme::CatmullClark;
    int proxyRate = 1;
    double depth = 0; // world units
    Vec2 tile{1, 1};
    double lengthStep = 0; // world units: places need not be written finer
    /// A sentence or two each; empty where there is nothing to say.
    struct Reasons {
        std::string camera, light, translate, scheme, proxyRate, depth, tile;
    } reasons;
};

/// `mesh` as readObj gives it. Throws InputError: a mesh without uvs, one its scheme doesn't take
/// (checkControlMesh, checkLimitTopology), one too small or too large for a scene file, uvs without area and
/// no tile given.
SceneDraft draftScene(const ControlMesh& mesh, const HeightMap& map, const DraftWishes& wishes);

} // namespace plumbline
