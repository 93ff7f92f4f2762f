#include "scenes/frame/frame_exr.h"

#include "scenes/image/exr_file.h"

namespace plumbline {

void writeFrame(const Frame& frame, const std::filesystem::path& file) {
    std::map<std::string, std::span<const float>> planes;
    for (const std::string& name : frame.channelNames())
        planes.emplace(name, frame.channel(name));
    writeExr(file, frame.width(), frame.height(), planes, frame.metadata);
}

} // namespace plumbline
