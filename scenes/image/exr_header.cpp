#include "scenes/image/exr_header.h"

#include "scenes/core/error.h"
#include "scenes/core/read_file.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace plumbline {
namespace {

constexpr uint32_t kMagic = 20000630;
constexpr uint32_t kFlagDeep = 0x800, kFlagMultiPart = 0x1000;
constexpr int64_t kMaxPixels = int64_t(1) << 30;
// Chunk tables grow with the height alone, so an image of 1 x 2^30 pixels must be rejected too.
constexpr int64_t kLongestSide = int64_t(1) << 20;
/// The library keeps whole headers in memory. Real headers have kilobytes, or a few megabytes with a preview
/// or a list of names.
constexpr uint64_t kLargestHeader = uint64_t(16) << 20;
constexpr size_t kMaxParts = 1024;

struct Window {
    int32_t left = 0, top = 0, right = -1, bottom = -1; // inclusive
    int64_t width() const { return int64_t(right) - left + 1; }
    int64_t height() const { return int64_t(bottom) - top + 1; }
    bool operator==(const Window&) const = default;
};

struct Summary {
    Window data, display;
    bool hasData = false, hasDisplay = false;
    uint8_t compression = 0;
    uint32_t tileWidth = 0, tileHeight = 0;
    double pixelBytes = 0; // of all channels; subsampled channels count proportionally
    std::string view;      // of a stereo picture
};

class Reader {
  public:
    explicit Reader(InputFile& file) : file_(file) {}

    [[noreturn]] void fail(const std::string& what, const std::string& expected = {}) const {
        throw InputError(file_.path().string(), what, expected);
    }
    [[noreturn]] void failTruncated() const { fail("is truncated", "a whole OpenEXR file"); }
    uint64_t size() const { return file_.size(); }

    template <class T>
    T number() {
        T value; // EXR is little-endian, and so is every machine Embree runs on
        if (file_.read({reinterpret_cast<char*>(&value), sizeof value}) != sizeof value) failTruncated();
        return value;
    }
    /// Reads a name and its terminating zero; names have at most 255 characters.
    std::string name() {
        std::string text;
        for (char c = number<char>(); c; c = number<char>()) {
            text += c;
            if (text.size() > 255) fail("has a damaged header: a name without end");
        }
        return text;
    }
    uint64_t position() const { return file_.position(); }
    void moveTo(uint64_t position) {
        if (position > size()) failTruncated();
        file_.moveTo(position);
    }

  private:
    InputFile& file_;
};

/// Whether the file has several parts.
bool readVersion(Reader& reader) {
    if (reader.size() < 8 || reader.number<uint32_t>() != kMagic) reader.fail("is not an OpenEXR file");
    const auto version = reader.number<uint32_t>();
    if (version & kFlagDeep) reader.fail("is a deep image", "flat pixels");
    return (version & kFlagMultiPart) != 0;
}

/// Bytes of one pixel: uint and float take 4, half 2.
double channelListBytes(Reader& reader) {
    double bytes = 0;
    while (!reader.name().empty()) {
        const double size = reader.number<int32_t>() == 1 ? 2 : 4;
        reader.number<int32_t>(); // pLinear
        const auto xSampling = reader.number<int32_t>(), ySampling = reader.number<int32_t>();
        if (xSampling < 1 || ySampling < 1) reader.fail("has a damaged header: a channel's sampling");
        bytes += size / xSampling / ySampling;
    }
    return bytes;
}

/// A string attribute has no length field of its own: its length is the attribute's size.
std::string readText(Reader& reader, int32_t size) {
    std::string text;
    for (int32_t k = 0; k < size && k < 255; ++k)
        text += reader.number<char>();
    return text;
}

void checkType(const Reader& reader, const std::string& type) {
    if (type == "scanlineimage" || type == "tiledimage") return;
    if (type == "deepscanline" || type == "deeptile") reader.fail("is a deep image", "flat pixels");
    reader.fail(fmt::format("has a part of the type '{}'", type), "scan lines or tiles");
}

Window readWindow(Reader& reader) {
    Window window;
    for (int32_t* side : {&window.left, &window.top, &window.right, &window.bottom})
        *side = reader.number<int32_t>();
    return window;
}

void readAttribute(Reader& reader, const std::string& name, const std::string& type, int32_t size,
                   Summary& summary) {
    if (name == "dataWindow" && type == "box2i") {
        summary.data = readWindow(reader);
        summary.hasData = true;
    } else if (name == "displayWindow" && type == "box2i") {
        summary.display = readWindow(reader);
        summary.hasDisplay = true;
    } else if (name == "compression" && size == 1) {
        summary.compression = reader.number<uint8_t>();
    } else if (name == "tiles" && size == 9) {
        summary.tileWidth = reader.number<uint32_t>();
        summary.tileHeight = reader.number<uint32_t>();
    } else if (name == "channels" && type == "chlist") {
        summary.pixelBytes = channelListBytes(reader);
    } else if (name == "type" && type == "string") {
        checkType(reader, readText(reader, size));
    } else if (name == "view" && type == "string") {
        summary.view = readText(reader, size);
    } else if (name == "multiView") {
        reader.fail("is a stereo picture, its views in one part", "one view");
    } else if (name == "envmap" && type == "envmap") {
        reader.fail(fmt::format("is an environment map ({}), not a picture of a pinhole camera",
                                reader.number<uint8_t>() == 0 ? "lat-long" : "cube"),
                    "a perspective or orthographic picture");
    }
}

/// Reads one header, which ends with an empty name.
Summary readAttributes(Reader& reader, std::string name) {
    Summary summary;
    for (; !name.empty(); name = reader.name()) {
        const std::string type = reader.name();
        const auto size = reader.number<int32_t>();
        if (size < 0) reader.fail("has a damaged header: attribute '" + name + "'");
        const uint64_t next = reader.position() + static_cast<uint64_t>(size);
        if (next > kLargestHeader)
            reader.fail(
                fmt::format("has a header of more than {} MB: attribute '{}'", kLargestHeader >> 20, name),
                "attributes of a picture");
        if (next > reader.size()) reader.failTruncated();
        readAttribute(reader, name, type, size, summary);
        reader.moveTo(next);
    }
    if (!summary.hasData || !summary.hasDisplay)
        reader.fail("has a damaged header: no data or display window");
    return summary;
}

/// A multi-part file has a header for each part, followed by an empty header.
std::vector<Summary> readHeaders(Reader& reader, bool multiPart) {
    if (!multiPart) return {readAttributes(reader, reader.name())};
    std::vector<Summary> parts;
    for (std::string name = reader.name(); !name.empty(); name = reader.name()) {
        if (parts.size() == kMaxParts)
            reader.fail(fmt::format("has more than {} parts", kMaxParts), "parts of one picture");
        parts.push_back(readAttributes(reader, name));
    }
    if (parts.empty()) reader.fail("has a damaged header: no part");
    return parts;
}

void checkPartsAgree(const Reader& reader, const std::vector<Summary>& parts) {
    for (const Summary& part : parts) {
        if (part.view != parts[0].view)
            reader.fail(
                fmt::format("is a stereo picture: it has the views '{}' and '{}'", parts[0].view, part.view),
                "one view; its parts can be split with exrmultipart");
        if (!(part.data == parts[0].data))
            reader.fail(fmt::format("has parts of {} x {} and {} x {} pixels", parts[0].data.width(),
                                    parts[0].data.height(), part.data.width(), part.data.height()),
                        "parts of one size and place; they can be split with exrmultipart");
    }
}

void checkWindows(const Reader& reader, const Summary& summary) {
    const int64_t width = summary.data.width(), height = summary.data.height();
    if (width < 1 || height < 1) reader.fail(fmt::format("has an empty data window, {} x {}", width, height));
    if (width > kLongestSide || height > kLongestSide || width * height > kMaxPixels)
        reader.fail(fmt::format("is {} x {} pixels large", width, height),
                    "at most 2^20 a side and 2^30 in all");
    if (!(summary.data == summary.display))
        reader.fail(
            fmt::format("is cropped: its data window is {} x {} at ({}, {}), its display window {} x {} at "
                        "({}, {})",
                        width, height, summary.data.left, summary.data.top, summary.display.width(),
                        summary.display.height(), summary.display.left, summary.display.top),
            "both windows the same");
    const uint64_t tilePixels = uint64_t(summary.tileWidth) * summary.tileHeight;
    constexpr uint64_t kLargeTile = uint64_t(1) << 22;
    if (tilePixels > std::max(kLargeTile, static_cast<uint64_t>(width * height)))
        reader.fail(
            fmt::format("has a damaged header: tiles of {} x {}", summary.tileWidth, summary.tileHeight));
}

/// The largest possible compression ratio of each of the format's methods: none; run lengths (127 bytes in
/// 2); the deflate family (1032:1); PIZ's Huffman runs; B44's fixed blocks; DWA, whose DCT blocks are
/// deflated again.
int64_t largestRatio(uint8_t compression) {
    constexpr std::array<int64_t, 10> kRatios{1, 64, 1100, 1100, 1100, 1100, 32, 32, 1 << 17, 1 << 17};
    return compression < kRatios.size() ? kRatios[compression] : 1 << 17;
}

void checkBytes(Reader& reader, const Summary& part) {
    const double pixels = static_cast<double>(part.data.width()) * static_cast<double>(part.data.height());
    const auto fileBytes = static_cast<double>(reader.size());
    if (pixels * part.pixelBytes / static_cast<double>(largestRatio(part.compression)) > fileBytes)
        reader.failTruncated();
    // The chunk table has 8 bytes per tile, which the library allocates unchecked.
    if (part.tileWidth > 0 && part.tileHeight > 0 &&
        8 * pixels / part.tileWidth / part.tileHeight > fileBytes)
        reader.failTruncated();
}

} // namespace

void checkExrHeader(InputFile& file) {
    Reader reader(file);
    const bool multiPart = readVersion(reader);
    const std::vector<Summary> parts = readHeaders(reader, multiPart);
    checkPartsAgree(reader,
                    parts); // first: a part of another size is also cropped
    for (const Summary& part : parts) {
        checkWindows(reader, part);
        checkBytes(reader, part);
    }
}

} // namespace plumbline
