// The camera of a scene as JSON, with all that another renderer needs to render the scene's mesh file
// (reference/export/mesh_file.h) with the same pixels.
#pragma once

#include "scenes/scene/scene.h"

#include <string>

namespace plumbline {

/// A JSON object:
///   program, scene, scene_hash   strings
///   conventions                  those below, in short, so that the file is self-contained
///   width, height                pixels, which are square; pixel (0,0) is the top-left one, its center at
///                                (0.5, 0.5)
///   aspect                       width / height
///   projection                   "perspective" with fov_y_degrees, the vertical field of view, or
///                                "orthographic" with view_height, the world units from the bottom to the
///                                top of the image
///   position, target, up         world: right-handed, Y up, world units
///   world_to_view, view_to_world 4 rows of 4; they multiply column vectors. View space: right-handed, the
///                                camera looks down -Z, +Y up
///   background                   linear RGB
///   lights                       name and kind: "directional" with to_light, a unit vector toward the
///                                light, or "point" with position
///   objects                      name, id (the frame's channel and the mesh file's object_id), color
///                                (linear RGB) and, with a relief, relief_depth in world units
std::string cameraJson(const Scene& scene);

} // namespace plumbline
