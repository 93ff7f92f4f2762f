// What a frame's header says of the scene it shows, written and read back, so that `compare` needs no scene
// file. Any program may write these fields (header_fields.h); values of another program that aren't as this
// one writes them are left out.
#pragma once

#include "scenes/frame/frame.h"
#include "scenes/scene/scene.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// Every field of the scene, its objects (object_info.h) among them.
std::map<std::string, std::string> sceneMetadata(const Scene& scene);

/// The value of the field `base`: "limit" or "proxy".
const char* baseName(Base base);

/// Whether this program wrote the frame; headers of others may use the same words for other things.
bool isPlumblines(const Frame& frame);

/// A field as it stands there; `otherwise` if there is none.
std::string headerField(const Frame& frame, const std::string& key, const std::string& otherwise = "");

/// The camera of a frame's header; nullopt if it has none, or another program's word that isn't as this one
/// writes it. Throws InputError, with `where` in front, for a value of this program's that can't be read, for
/// numbers no scene file could have and for a camera of a picture of another size.
std::optional<Camera> cameraFromHeader(const Frame& frame, const std::string& where);

/// The lights of a frame's header, by name. Throws InputError for a value of this program's that can't be
/// read.
std::vector<Light> lightsFromHeader(const Frame& frame, const std::string& where);

/// The camera, the lights the frame has shadows of and what is said of objects that are another program's
/// word and left out: names of header fields. Throws as those that read them.
std::vector<std::string> leftOutFields(const Frame& frame, const std::string& where);

} // namespace plumbline
