// What a frame's header says about its scene (written by scenes/frame/scene_metadata.h), read back, so that
// `compare` needs no scene file. Any program may write these keys.
#pragma once

#include "scenes/scene/camera.h"
#include "scenes/scene/scene.h"
#include "validate/metrics/frame_pair.h"
#include "validate/results/certificate.h"

namespace plumbline {

/// What metrics must know about a scene's objects; ids as in its frames.
std::vector<ObjectInfo> objectsOf(const Scene& scene);

/// The same from a frame's header, by its keys `object.<id>.…`; empty if it has none. Throws InputError, with
/// `where` in front, for a value of this program's that can't be read; another's is left out.
std::vector<ObjectInfo> objectsFromHeader(const Frame& frame, const std::string& where);

/// Whether this program wrote the frame; headers of others may use the same words for other things.
bool isPlumblines(const Frame& frame);

/// The camera of a frame's header; nullopt if it has none, or another program's word that isn't as this one
/// writes it. Throws likewise, also for numbers no scene file could have and for one of a picture of another
/// size.
std::optional<Camera> cameraFromHeader(const Frame& frame, const std::string& where);

/// The lights of a frame's header, by its keys `light.<name>`; those of another program that aren't as this
/// one writes them are left out. Throws likewise.
std::vector<Light> lightsFromHeader(const Frame& frame, const std::string& where);

/// The camera, the lights the frame has shadows of and what is said of objects that are another program's
/// word and left out: names of header fields. Throws likewise.
std::vector<std::string> leftOutFields(const Frame& frame, const std::string& where);

/// What a reference's frame says of its own error: the header fields certificate.error_px_p99 and its like
/// (see certificate.h), numbers >= 0, and the counts of its channels. What isn't there is absent. Throws
/// likewise.
CertificateSummary certificateFromHeader(const Frame& frame, const std::string& where);

} // namespace plumbline
