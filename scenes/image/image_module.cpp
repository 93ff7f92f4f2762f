// Reads and writes images with OpenImageIO. Built as a separate module because linking to OpenImageIO costs a
// program 0.25 s and 130 MB before main().
#include "scenes/image/image_module.h"

#include "scenes/core/index.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace {

namespace oiio = OIIO;

/// Thrown and caught inside the module.
struct Failure {
    std::string what;
};

struct Layout {
    std::vector<int> channels; // of the file, in the order R G B A, Y, or Y A
    bool integer8 = false, integer16 = false;
};

std::unique_ptr<oiio::ImageInput> openPicture(const char* file) {
    oiio::ImageSpec hints;
    hints["oiio:UnassociatedAlpha"] = 1; // colors as stored, not premultiplied with alpha
    auto input = oiio::ImageInput::open(file, &hints);
    if (!input) throw Failure{fmt::format("is not a picture that can be read ({})", oiio::geterror())};
    return input;
}

std::optional<int> findChannel(const oiio::ImageSpec& spec, const char* name) {
    for (int c = 0; c < spec.nchannels; ++c)
        if (spec.channel_name(c) == name) return c;
    return std::nullopt;
}

/// Channels are found by name, because OpenImageIO's channel order varies.
std::vector<int> orderChannels(const oiio::ImageSpec& spec) {
    const auto r = findChannel(spec, "R"), g = findChannel(spec, "G"), b = findChannel(spec, "B");
    const auto alpha = findChannel(spec, "A");
    std::vector<int> order;
    if (r && g && b) {
        order = {*r, *g, *b};
    } else if (const auto gray = findChannel(spec, "Y")) {
        order = {*gray};
    } else if (spec.nchannels == 1) {
        order = {0};
    } else {
        std::string names;
        for (int c = 0; c < std::min(spec.nchannels, 16); ++c)
            names += fmt::format(" {}", std::string(spec.channel_name(c)));
        throw Failure{
            fmt::format("has the channels{}; expected R G B, R G B A, gray, or gray with alpha", names)};
    }
    if (alpha && spec.nchannels > 1) order.push_back(*alpha);
    return order;
}

/// OpenImageIO reserves memory for whole strips, and with sizes from 2^31 bytes on it doesn't come back.
/// Strips may have more rows than the picture (many programs write the same number into every file).
void checkStrips(const oiio::ImageSpec& spec) {
    const int64_t rows = spec.get_int_attribute("tiff:RowsPerStrip");
    if (rows > spec.height && rows * static_cast<int64_t>(spec.scanline_bytes(true)) >= int64_t(1) << 31)
        throw Failure{
            fmt::format("claims strips of {} rows; expected at most its {} rows", rows, spec.height)};
}

Layout checkSpec(const oiio::ImageSpec& spec) {
    const int64_t pixels = int64_t(spec.width) * spec.height;
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1)
        throw Failure{"has no plain two-dimensional pixels"};
    if (pixels > plumbline::kMaxPicturePixels)
        throw Failure{
            fmt::format("is {} x {} pixels large; expected at most 2^30 pixels", spec.width, spec.height)};
    if (spec.nchannels < 1 || spec.nchannels > 64)
        throw Failure{fmt::format("has {} channels; expected 1 to 4", spec.nchannels)};
    checkStrips(spec);
    Layout layout;
    layout.channels = orderChannels(spec);
    layout.integer8 = spec.format == oiio::TypeDesc::UINT8;
    layout.integer16 = spec.format == oiio::TypeDesc::UINT16;
    // NOLINTNEXTLINE(misc-redundant-expression): three different types
    const bool floating = spec.format == oiio::TypeDesc::HALF || spec.format == oiio::TypeDesc::FLOAT ||
                          spec.format == oiio::TypeDesc::DOUBLE;
    if (!layout.integer8 && !layout.integer16 && !floating)
        throw Failure{
            fmt::format("stores {} values; expected 8 or 16-bit integers or floats", spec.format.c_str())};
    return layout;
}

/// Reads rows [begin, end) in the file's own data type; tiled files can only be read in whole rows of tiles.
void readBand(oiio::ImageInput& input, const oiio::ImageSpec& spec, int begin, int end,
              const oiio::TypeDesc& type, void* into) {
    const bool ok = spec.tile_width > 0 ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + begin,
                                                           spec.y + end, 0, 1, 0, spec.nchannels, type, into)
                                        : input.read_scanlines(0, 0, spec.y + begin, spec.y + end, 0, 0,
                                                               spec.nchannels, type, into);
    // Some readers (libtiff's among them) report damage without failing.
    if (!ok || input.has_error())
        throw Failure{fmt::format("is damaged, truncated, or stored in a way that can't be read ({})",
                                  input.geterror())};
}

/// Integers are divided in double, so that v / 255 is the nearest float; OpenImageIO's own conversion is 1
/// ulp off.
template <class Stored>
void convert(std::span<const Stored> stored, size_t fileChannels, const Layout& layout, double divisor,
             std::vector<float>& values) {
    values.clear();
    for (; !stored.empty(); stored = stored.subspan(fileChannels))
        for (const int channel : layout.channels)
            values.push_back(static_cast<float>(plumbline::item(stored, channel) / divisor));
}

/// Rows to read at once. A TIFF that stores its channels apart and compresses them can only be read in whole
/// strips: going to the next channel of a row means going back in the file.
int rowsPerBand(const oiio::ImageSpec& spec) {
    constexpr int kRows = 64;
    if (spec.tile_width > 0) return std::max(1, spec.tile_height);
    if (spec.get_string_attribute("planarconfig") != "separate") return kRows;
    const int stripRows =
        std::clamp(spec.get_int_attribute("tiff:RowsPerStrip", spec.height), 1, spec.height);
    return (kRows + stripRows - 1) / stripRows * stripRows;
}

/// Reads band by band, so that a truncated file fails before memory for all of its claimed pixels is touched.
template <class Stored>
void readRows(oiio::ImageInput& input, const oiio::ImageSpec& spec, const Layout& layout, oiio::TypeDesc type,
              double divisor, const PlumblinePictureSink& sink) {
    const int bandRows = rowsPerBand(spec);
    const auto fileChannels = static_cast<size_t>(spec.nchannels);
    std::vector<Stored> stored;
    std::vector<float> values;
    for (int begin = 0; begin < spec.height; begin += bandRows) {
        const int end = std::min(spec.height, begin + bandRows);
        stored.resize(plumbline::areaOf(spec.width, end - begin) * fileChannels);
        readBand(input, spec, begin, end, type, stored.data());
        convert<Stored>(stored, fileChannels, layout, divisor, values);
        if (!sink.values(sink.user, values.data(), values.size())) return;
    }
}

void readPicture(const char* file, const PlumblinePictureSink& sink) {
    const auto input = openPicture(file);
    const oiio::ImageSpec spec = input->spec();
    const Layout layout = checkSpec(spec);
    const bool integer = layout.integer8 || layout.integer16;
    if (!sink.begin(sink.user, spec.width, spec.height, plumbline::countOf(layout.channels), integer)) return;
    if (layout.integer8)
        readRows<uint8_t>(*input, spec, layout, oiio::TypeDesc::UINT8, 255.0, sink);
    else if (layout.integer16)
        readRows<uint16_t>(*input, spec, layout, oiio::TypeDesc::UINT16, 65535.0, sink);
    else
        readRows<float>(*input, spec, layout, oiio::TypeDesc::FLOAT, 1.0, sink);
}

void encodePng(int width, int height, const uint8_t* rgb, const PlumblineFileSink& sink) {
    auto output = oiio::ImageOutput::create("png");
    oiio::Filesystem::IOVecOutput file; // in memory
    if (!output || !output->set_ioproxy(&file))
        throw Failure{fmt::format("can't be written ({})", oiio::geterror())};
    oiio::ImageSpec spec(width, height, 3, oiio::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    // zlib compression level: 2 takes a third of the time of the default 6 and produces 10 % more bytes.
    spec.attribute("png:compressionLevel", 2);
    if (!output->open("picture.png", spec) || !output->write_image(oiio::TypeDesc::UINT8, rgb) ||
        !output->close())
        throw Failure{fmt::format("can't be written ({})", output->geterror())};
    sink.contents(sink.user, file.buffer().data(), file.buffer().size());
}

/// Runs `action` and reports any exception through `fail`.
template <class Action>
void guarded(void* user, void (*fail)(void*, const char*), const Action& action) {
    try {
        action();
    } catch (const Failure& failure) {
        fail(user, failure.what.c_str());
    } catch (const std::bad_alloc&) {
        fail(user, plumbline::kOutOfMemory);
    } catch (const std::exception& error) {
        fail(user, error.what());
    } catch (...) {
        fail(user, "OpenImageIO failed without a reason");
    }
}

} // namespace

extern "C" {

__attribute__((visibility("default"))) void plumblineReadPicture(const char* file,
                                                                 const PlumblinePictureSink* sink) {
    guarded(sink->user, sink->fail, [&] { readPicture(file, *sink); });
}

__attribute__((visibility("default"))) void plumblineEncodePng(int width, int height, const uint8_t* rgb,
                                                               const PlumblineFileSink* sink) {
    guarded(sink->user, sink->fail, [&] { encodePng(width, height, rgb, *sink); });
}
}
