// What a frame's file says of the scene it shows.
#pragma once

#include "scenes/scene/scene.h"

#include <map>
#include <string>

namespace plumbline {

/// Keys, all with string values:
///   program                   name and version
///   scene, scene_hash         name and Scene::hash
///   scene_changes             Scene::changes, separated by ", "; only if there are any
///   camera                    one line: projection, position, target, up, field of view or view height, size
///   in
///                             pixels
///   lights                    names, separated by spaces
///   light.<name>              "to_light x y z": direction toward it, world; or "position x y z", world
///   object.<id>.name          <id> is the value of the frame's id channel, from 1
///   object.<id>.relief_depth  world units; only objects with a relief have it and the three that follow
///   object.<id>.relief_axis   "x y z", unit, world: what it goes along; absent where that is the normal
///   object.<id>.map_texels    "width height" of the relief map
///   object.<id>.map_wrap      "repeat clamp": along s and t
/// validate/compare/frame_metadata.h reads them back.
std::map<std::string, std::string> sceneMetadata(const Scene& scene);

/// Name and version of the program: "plumbline 0.1.0".
std::string programName();

} // namespace plumbline
