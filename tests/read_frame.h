// Reads the frames that a program has written.
#pragma once

#include "scenes/frame/frame.h"
#include "scenes/image/exr_file.h"

#include <algorithm>
#include <filesystem>

namespace plumbline {

/// The channels of the file that are in the channel table, and its string attributes as metadata. Throws as
/// readExr does.
inline Frame readFrame(const std::filesystem::path& file) {
    ExrPlanes exr = readExr(file, [](std::vector<std::string> names) {
        std::erase_if(names, [](const std::string& name) { return !isFrameChannel(name); });
        return names;
    });
    Frame frame(exr.width, exr.height);
    for (const auto& [name, plane] : exr.planes)
        std::ranges::copy(plane, frame.add(name).begin());
    frame.metadata = std::move(exr.attributes);
    return frame;
}

} // namespace plumbline
