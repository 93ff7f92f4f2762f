#include "exr_file.h"

#include "error.h"
#include "exr_header.h"
#include "replace_file.h"

#include <fmt/format.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <mutex>
#include <thread>

namespace plumbline {
namespace {

/// zlib's level. Pixels of a frame are noisy floats: higher levels cost time and gain next to nothing.
constexpr int kZipLevel = 1;

// What OpenEXR itself keeps in a header under these names.
constexpr std::array kReservedAttributes{"channels",
                                         "compression",
                                         "dataWindow",
                                         "displayWindow",
                                         "lineOrder",
                                         "pixelAspectRatio",
                                         "tiles",
                                         "view",
                                         "screenWindowCenter",
                                         "screenWindowWidth",
                                         "chunkCount",
                                         "maxSamplesPerPixel",
                                         "type",
                                         "name",
                                         "version"};

bool isReserved(const std::string& attribute) {
    return std::find(kReservedAttributes.begin(), kReservedAttributes.end(), attribute) !=
           kReservedAttributes.end();
}

/// Chunks are compressed by several threads and written in order, so that bytes don't depend on their number.
void useAllThreads() {
    static std::once_flag once;
    std::call_once(once,
                   [] { Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency())); });
}

/// A stream whose failures are still known after OutputFile's destructor, which swallows them.
class CheckedStream : public Imf::OStream {
  public:
    explicit CheckedStream(const std::filesystem::path& file)
        : OStream(file.c_str()), stream_(file, std::ios::binary) {}
    void write(const char bytes[], int count) override { stream_.write(bytes, count); }
    uint64_t tellp() override { return static_cast<uint64_t>(std::streamoff(stream_.tellp())); }
    void seekp(uint64_t position) override { stream_.seekp(static_cast<std::streamoff>(position)); }
    bool closeAndCheck() {
        stream_.close();
        return stream_.good();
    }

  private:
    std::ofstream stream_;
};

/// The frame buffer's address of pixel (0,0) of the window, given that of the window's first pixel.
Imf::Slice planeSlice(float* plane, const Imath::Box2i& window) {
    return Imf::Slice::Make(Imf::FLOAT, plane, window, sizeof(float), 0);
}

std::vector<std::string> channelNames(const Imf::Header& header) {
    std::vector<std::string> names;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        names.emplace_back(it.name());
    return names;
}

std::map<std::string, std::string> stringAttributes(const Imf::Header& header) {
    std::map<std::string, std::string> attributes;
    for (auto it = header.begin(); it != header.end(); ++it)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
            if (!isReserved(it.name())) attributes[it.name()] = text->value();
    return attributes;
}

ExrPlanes readPlanes(const std::filesystem::path& file, const ExrSelection& select) {
    Imf::InputFile input(file.c_str());
    const Imf::Header& header = input.header();
    if (!input.isComplete()) throw InputError(file.string(), "is truncated", "a whole OpenEXR file");
    const Imath::Box2i window = header.dataWindow();
    ExrPlanes exr;
    exr.width = window.max.x - window.min.x + 1;
    exr.height = window.max.y - window.min.y + 1;
    Imf::FrameBuffer buffer;
    for (const std::string& name : select(channelNames(header))) {
        const Imf::Channel* channel = header.channels().findChannel(name);
        if (!channel || channel->xSampling != 1 || channel->ySampling != 1)
            throw InputError(file.string(), fmt::format("channel '{}' is subsampled", name),
                             "a value of it for every pixel");
        std::vector<float>& plane = exr.planes[name];
        plane.resize(static_cast<size_t>(exr.width) * static_cast<size_t>(exr.height));
        buffer.insert(name, planeSlice(plane.data(), window));
    }
    input.setFrameBuffer(buffer);
    input.readPixels(window.min.y, window.max.y);
    exr.attributes = stringAttributes(header);
    return exr;
}

Imf::Header makeHeader(const std::filesystem::path& file, int width, int height,
                       const std::map<std::string, std::string>& attributes) {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = kZipLevel;
    for (const auto& [name, value] : attributes) {
        if (isReserved(name) || name.empty() || name.size() > 255)
            throw InputError(file.string(), fmt::format("metadata can't be stored under the name '{}'", name),
                             "1 to 255 letters, not a name that OpenEXR uses itself");
        header.insert(name, Imf::StringAttribute(value));
    }
    return header;
}

} // namespace

ExrPlanes readExr(const std::filesystem::path& file, const ExrSelection& select) {
    checkExrHeader(file);
    useAllThreads();
    try {
        return readPlanes(file, select);
    } catch (const InputError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw MachineError(file.string(), "not enough memory to read it");
    } catch (const std::exception& error) {
        throw InputError(file.string(), fmt::format("is damaged or truncated ({})", error.what()),
                         "a whole OpenEXR file");
    }
}

void writeExr(const std::filesystem::path& file, int width, int height,
              const std::map<std::string, std::span<const float>>& planes,
              const std::map<std::string, std::string>& attributes) {
    if (width < 1 || height < 1 || planes.empty())
        throw InputError(file.string(),
                         fmt::format("a frame of {} x {} pixels and {} channels can't be written", width,
                                     height, planes.size()));
    useAllThreads();
    Imf::Header header = makeHeader(file, width, height, attributes);
    Imf::FrameBuffer buffer;
    for (const auto& [name, plane] : planes) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        buffer.insert(name,
                      planeSlice(const_cast<float*>(plane.data()), header.dataWindow())); // only read from
    }
    replaceFile(file, [&](const std::filesystem::path& temporary) {
        CheckedStream stream(temporary);
        try {
            Imf::OutputFile output(stream, header);
            output.setFrameBuffer(buffer);
            output.writePixels(height);
        } catch (const std::bad_alloc&) {
            throw MachineError(file.string(), "not enough memory to write it");
        } catch (const std::exception& error) {
            throw InputError(file.string(), fmt::format("can't be written ({})", error.what()));
        }
        if (!stream.closeAndCheck())
            throw InputError(file.string(), "can't be written: no space or no permission");
    });
}

} // namespace plumbline
