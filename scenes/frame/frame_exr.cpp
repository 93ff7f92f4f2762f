#include "scenes/frame/frame_exr.h"

#include "scenes/core/error.h"
#include "scenes/image/exr_file.h"

#include <algorithm>

namespace plumbline {
void writeFrame(const Frame& frame, const std::filesystem::path& file) {
    std::map<std::string, std::span<const float>> planes;
    for (const std::string& name : frame.channelNames())
        planes.emplace(name, frame.channel(name));
    writeExr(file, frame.width(), frame.height(), planes, frame.metadata);
}

Frame readFrame(const std::filesystem::path& file) {
    ExrPlanes exr = readExr(file, [&](std::vector<std::string> names) {
        const auto known = std::stable_partition(names.begin(), names.end(), isFrameChannel);
        if (known == names.begin())
            throw InputError(file.string(), "has no channel of a frame; its channels are " + listOf(names),
                             "Z or P.X P.Y P.Z, A or id, and the rest of the channel table");
        names.erase(known, names.end());
        return names;
    });
    Frame frame(exr.width, exr.height);
    for (const auto& [name, plane] : exr.planes)
        std::copy(plane.begin(), plane.end(), frame.add(name).begin());
    frame.metadata = std::move(exr.attributes);
    return frame;
}

} // namespace plumbline
