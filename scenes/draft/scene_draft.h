// A draft scene for a given mesh and height map: camera, light, relief depth and texture repetition. Every
// choice comes with a reason, which becomes a comment in the scene file.
#pragma once

#include "scenes/scene/scene.h"

#include <filesystem>

namespace plumbline {

/// Values fixed by the user.
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
    bool merge = false;    // vertices at the same place
    double lengthStep = 0; // world units: resolution at which positions are written
    /// One or two sentences each; may be empty.
    struct Reasons {
        std::string camera, light, translate, scheme, merge, proxyRate, depth, tile;
    } reasons;
};

/// `mesh` is a mesh read by readObj. Throws InputError for a mesh without uvs, a mesh that is invalid for its
/// scheme (checkControlMesh, checkLimitTopology), a mesh too small or too large for a scene file, and uvs
/// without area if no tile is given.
SceneDraft draftScene(const ControlMesh& mesh, const HeightMap& map, const DraftWishes& wishes);

} // namespace plumbline
