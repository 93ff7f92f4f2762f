#include "scenes/image/exr_file.h"

#include "scenes/core/contains.h"
#include "scenes/core/error.h"
#include "scenes/core/index.h"
#include "scenes/core/read_file.h"
#include "scenes/core/replace_file.h"
#include "scenes/image/exr_header.h"

#include <fmt/format.h>

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace plumbline {
namespace {

/// zlib compression level. A frame's pixels are noisy floats, so higher levels cost time and save almost
/// nothing.
constexpr int kZipLevel = 1;

// Attribute names that OpenEXR itself uses.
constexpr std::array<std::string_view, 15> kReservedAttributes{"channels",
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

/// Chunks are compressed by several threads and written in order, so the bytes don't depend on the thread
/// count.
void useAllThreads() {
    static std::once_flag once;
    std::call_once(once,
                   [] { Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency())); });
}

/// What OpenEXR writes to. Its OutputFile swallows a failure in its destructor; the stream keeps it.
class ExrStream : public Imf::OStream {
  public:
    ExrStream(OutputStream& stream, const std::filesystem::path& file)
        : OStream(file.c_str()), stream_(stream) {}
    void write(const char bytes[], int count) override { stream_.write({bytes, static_cast<size_t>(count)}); }
    uint64_t tellp() override { return stream_.position(); }
    void seekp(uint64_t position) override { stream_.seek(position); }

  private:
    OutputStream& stream_;
};

/// What OpenEXR reads from. The file that it reads is the one whose header was checked.
class FileStream : public Imf::IStream {
  public:
    explicit FileStream(InputFile& file) : IStream(file.path().c_str()), file_(file) {}
    /// Whether there is more to read.
    bool read(char bytes[], int count) override {
        const auto wanted = static_cast<size_t>(count);
        if (file_.read({bytes, wanted}) != wanted) throw std::runtime_error("unexpected end of the file");
        return file_.position() < file_.size();
    }
    uint64_t tellg() override { return file_.position(); }
    void seekg(uint64_t position) override { file_.moveTo(position); }

  private:
    InputFile& file_;
};

/// A frame-buffer slice. OpenEXR expects the address of pixel (0,0); `plane` begins at the data window's
/// first pixel.
Imf::Slice planeSlice(float* plane, const Imath::Box2i& window) {
    return Imf::Slice::Make(Imf::FLOAT, plane, window, sizeof(float), 0);
}

/// A channel of a single-part or multi-part file.
struct PartChannel {
    int part;
    std::string name; // within the part
};
using PartChannels = std::map<std::string, PartChannel>;

/// Lists channels by unique name. A channel whose name also occurs in an earlier part is prefixed with its
/// part's name, because layers written as parts may all have the channels R, G and B.
PartChannels listChannels(const Imf::MultiPartInputFile& input, const std::string& where) {
    PartChannels channels;
    for (int part = 0; part < input.parts(); ++part) {
        const Imf::Header& header = input.header(part);
        for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
            const std::string name = it.name();
            if (channels.try_emplace(name, PartChannel{part, name}).second) continue;
            const std::string inPart = header.name() + "." + name;
            if (!channels.try_emplace(inPart, PartChannel{part, name}).second)
                throw InputError(where, fmt::format("has two channels '{}'", inPart), "a name for each");
        }
    }
    return channels;
}

void addStringAttributes(const Imf::Header& header, std::map<std::string, std::string>& attributes) {
    for (auto it = header.begin(); it != header.end(); ++it)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
            if (!contains(kReservedAttributes, std::string_view(it.name())))
                attributes.try_emplace(it.name(), text->value());
}

/// Adds those channels of a part that are in `chosen` to `exr`.
void readPart(Imf::MultiPartInputFile& input, int part, const PartChannels& chosen, const std::string& where,
              ExrPlanes& exr) {
    const Imf::Header& header = input.header(part);
    const Imath::Box2i window = header.dataWindow();
    Imf::FrameBuffer buffer;
    bool any = false;
    for (const auto& [name, channel] : chosen) {
        if (channel.part != part) continue;
        const Imf::Channel* found = header.channels().findChannel(channel.name);
        if (!found || found->xSampling != 1 || found->ySampling != 1)
            throw InputError(where, fmt::format("channel '{}' is subsampled", name),
                             "a value of it for every pixel");
        std::vector<float>& plane = exr.planes[name];
        plane.resize(areaOf(exr.width, exr.height));
        buffer.insert(channel.name, planeSlice(plane.data(), window));
        any = true;
    }
    if (!any) return;
    Imf::InputPart pixels(input, part);
    pixels.setFrameBuffer(buffer);
    pixels.readPixels(window.min.y, window.max.y);
}

ExrPlanes readPlanes(InputFile& opened, const ExrSelection& select) {
    const std::filesystem::path& file = opened.path();
    FileStream stream(opened);
    Imf::MultiPartInputFile input(stream);
    for (int part = 0; part < input.parts(); ++part)
        if (!input.partComplete(part))
            throw InputError(file.string(), "is truncated", "a whole OpenEXR file");
    const PartChannels channels = listChannels(input, file.string());
    std::vector<std::string> names;
    for (const auto& [name, channel] : channels)
        names.push_back(name);
    PartChannels chosen;
    for (const std::string& name : select(names))
        chosen.emplace(name, channels.at(name));

    const Imath::Box2i window = input.header(0).dataWindow();
    ExrPlanes exr;
    exr.width = window.max.x - window.min.x + 1;
    exr.height = window.max.y - window.min.y + 1;
    for (int part = 0; part < input.parts(); ++part) {
        readPart(input, part, chosen, file.string(), exr);
        addStringAttributes(input.header(part), exr.attributes);
    }
    return exr;
}

Imf::Header makeHeader(const std::filesystem::path& file, int width, int height,
                       const std::map<std::string, std::string>& attributes) {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = kZipLevel;
    for (const auto& [name, value] : attributes) {
        if (contains(kReservedAttributes, name) || name.empty() || name.size() > 255)
            throw InputError(file.string(), fmt::format("metadata can't be stored under the name '{}'", name),
                             "1 to 255 letters, not a name that OpenEXR uses itself");
        header.insert(name, Imf::StringAttribute(value));
    }
    return header;
}

} // namespace

ExrPlanes readExr(const std::filesystem::path& file, const ExrSelection& select) {
    InputFile opened(file);
    checkExrHeader(opened);
    opened.moveTo(0);
    useAllThreads();
    try {
        ExrPlanes planes = readPlanes(opened, select);
        opened.checkUnchanged();
        return planes;
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
        assert(plane.size() == areaOf(width, height));
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        buffer.insert(name,
                      planeSlice(const_cast<float*>(plane.data()), header.dataWindow())); // only read from
    }
    replaceFile(file, [&](OutputStream& written) {
        ExrStream stream(written, file);
        try {
            Imf::OutputFile output(stream, header);
            output.setFrameBuffer(buffer);
            output.writePixels(height);
        } catch (const std::bad_alloc&) {
            throw MachineError(file.string(), "not enough memory to write it");
        } catch (const Iex::BaseExc& error) {
            throw InputError(file.string(), fmt::format("can't be written ({})", error.what()));
        }
    });
}

} // namespace plumbline
