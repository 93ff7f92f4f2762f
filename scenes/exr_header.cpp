#include "exr_header.h"

#include "error.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

namespace plumbline {
namespace {

constexpr uint32_t kMagic = 20000630;
constexpr uint32_t kFlagDeep = 0x800, kFlagMultiPart = 0x1000;
constexpr int64_t kMostPixels = int64_t(1) << 30;
// Tables of chunks grow with the height alone, so a picture of 1 x 2^30 is refused too.
constexpr int64_t kLongestSide = int64_t(1) << 20;

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
    int64_t pixelBytes = 0; // of all channels together
};

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file) : file_(file), stream_(file, std::ios::binary) {
        std::error_code error;
        if (!std::filesystem::exists(file, error)) throw InputError(file.string(), "no such file");
        if (std::filesystem::is_directory(file, error))
            throw InputError(file.string(), "is a folder", "an OpenEXR file");
        if (!stream_) throw InputError(file.string(), "can't be opened for reading");
        size_ = std::filesystem::file_size(file, error);
        if (error) throw InputError(file.string(), "can't be read: " + error.message());
    }

    [[noreturn]] void fail(const std::string& what, const std::string& expected = {}) const {
        throw InputError(file_.string(), what, expected);
    }
    [[noreturn]] void failTruncated() const { fail("is truncated", "a whole OpenEXR file"); }
    uint64_t size() const { return size_; }

    template <class T>
    T number() {
        T value; // EXR is little-endian, and so is every machine Embree runs on
        if (!stream_.read(reinterpret_cast<char*>(&value), sizeof value)) failTruncated();
        return value;
    }
    /// Up to the terminating zero, which is eaten; names have at most 255 letters.
    std::string name() {
        std::string text;
        for (char c = number<char>(); c; c = number<char>()) {
            text += c;
            if (text.size() > 255) fail("has a damaged header: a name without end");
        }
        return text;
    }
    uint64_t position() { return static_cast<uint64_t>(stream_.tellg()); }
    void moveTo(uint64_t position) {
        if (position > size_) failTruncated();
        stream_.seekg(static_cast<std::streamoff>(position));
    }

  private:
    std::filesystem::path file_;
    std::ifstream stream_;
    uint64_t size_ = 0;
};

void readVersion(Reader& reader) {
    if (reader.size() < 8 || reader.number<uint32_t>() != kMagic) reader.fail("is not an OpenEXR file");
    const auto version = reader.number<uint32_t>();
    if (version & kFlagMultiPart)
        reader.fail("has several parts",
                    "a single-part OpenEXR file; its parts can be split with exrmultipart");
    if (version & kFlagDeep) reader.fail("is a deep image", "flat pixels");
}

/// Bytes of one pixel: uint and float take 4, half 2.
int64_t channelListBytes(Reader& reader) {
    int64_t bytes = 0;
    while (!reader.name().empty()) {
        bytes += reader.number<int32_t>() == 1 ? 2 : 4;
        for (int skipped = 0; skipped < 3; ++skipped)
            reader.number<int32_t>(); // pLinear, samplings
    }
    return bytes;
}

Window readWindow(Reader& reader) {
    Window window;
    for (int32_t* side : {&window.left, &window.top, &window.right, &window.bottom})
        *side = reader.number<int32_t>();
    return window;
}

Summary readAttributes(Reader& reader) {
    Summary summary;
    for (std::string name = reader.name(); !name.empty(); name = reader.name()) {
        const std::string type = reader.name();
        const auto size = reader.number<int32_t>();
        if (size < 0) reader.fail("has a damaged header: attribute '" + name + "'");
        const uint64_t next = reader.position() + static_cast<uint64_t>(size);
        if (next > reader.size()) reader.failTruncated();
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
        }
        reader.moveTo(next);
    }
    if (!summary.hasData || !summary.hasDisplay)
        reader.fail("has a damaged header: no data or display window");
    return summary;
}

void checkWindows(const Reader& reader, const Summary& summary) {
    const int64_t width = summary.data.width(), height = summary.data.height();
    if (width < 1 || height < 1) reader.fail(fmt::format("has an empty data window, {} x {}", width, height));
    if (width > kLongestSide || height > kLongestSide || width * height > kMostPixels)
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

/// Compression n of the format can't shrink pixels by more than this: none; run lengths (127 bytes in 2); the
/// deflate family 1032:1; PIZ's Huffman runs; B44's fixed blocks; DWA, whose cosine blocks are deflated
/// again.
int64_t largestRatio(uint8_t compression) {
    constexpr std::array<int64_t, 10> kRatios{1, 64, 1100, 1100, 1100, 1100, 32, 32, 1 << 17, 1 << 17};
    return compression < kRatios.size() ? kRatios[compression] : 1 << 17;
}

} // namespace

void checkExrHeader(const std::filesystem::path& file) {
    Reader reader(file);
    readVersion(reader);
    const Summary summary = readAttributes(reader);
    checkWindows(reader, summary);
    const int64_t claimedBytes = summary.data.width() * summary.data.height() * summary.pixelBytes;
    if (claimedBytes / largestRatio(summary.compression) > static_cast<int64_t>(reader.size()))
        reader.failTruncated();
}

} // namespace plumbline
