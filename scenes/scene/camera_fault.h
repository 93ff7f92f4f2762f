// What is wrong with a camera's numbers, whoever named them: a scene file or the header of a frame.
#pragma once

#include "scenes/scene/camera.h"

#include <optional>
#include <string>

namespace plumbline {

struct CameraFault {
    const char* field; // as scene files call it
    std::string found, expected;
};

/// The first thing that no camera may have; nullopt if there is none. The size of the picture isn't looked
/// at.
std::optional<CameraFault> findFault(const Camera& camera);

/// The same of one place.
std::optional<CameraFault> findPlaceFault(const char* field, const Vec3& place);

} // namespace plumbline
