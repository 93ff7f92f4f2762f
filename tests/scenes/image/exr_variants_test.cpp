// EXR files as other programs write them: several parts, ripmaps, subsampled channels, deep pixels,
// environment maps, stereo images, and invalid headers. Each is read or rejected with a reason.
#include "scenes/image/exr_file.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfEnvmapAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <random>
#include <sys/resource.h>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Key;

constexpr int kWidth = 10, kHeight = 5, kPixels = kWidth * kHeight;
const Imath::Box2i kWindow({0, 0}, {kWidth - 1, kHeight - 1});

ExrPlanes readAll(const std::filesystem::path& file) {
    return readExr(file, [](const std::vector<std::string>& names) { return names; });
}

std::string errorOf(const std::filesystem::path& file) {
    return inputErrorOf([&] { readAll(file); });
}

/// A part with one channel of the constant `value`.
struct Part {
    std::string name, channel;
    float value;
    Imath::Box2i window = kWindow;
    std::string view{};
};

void writeParts(const std::filesystem::path& file, const std::vector<Part>& parts) {
    std::vector<Imf::Header> headers;
    for (const Part& part : parts) {
        Imf::Header header(kWindow, part.window); // display, data
        header.channels().insert(part.channel, Imf::Channel(Imf::FLOAT));
        header.setName(part.name);
        header.setType(Imf::SCANLINEIMAGE);
        if (!part.view.empty()) header.setView(part.view);
        header.insert("made by " + part.name, Imf::StringAttribute("yes"));
        headers.push_back(header);
    }
    Imf::MultiPartOutputFile output(file.c_str(), headers.data(), static_cast<int>(headers.size()));
    for (size_t k = 0; k < parts.size(); ++k) {
        const Imath::V2i size = parts[k].window.size() + Imath::V2i(1);
        std::vector<float> pixels(static_cast<size_t>(size.x * size.y), parts[k].value);
        Imf::FrameBuffer buffer;
        buffer.insert(parts[k].channel, Imf::Slice::Make(Imf::FLOAT, pixels.data(), parts[k].window));
        Imf::OutputPart part(output, static_cast<int>(k));
        part.setFrameBuffer(buffer);
        part.writePixels(size.y);
    }
}

/// One part, scan lines; `change` edits its header, which has a float channel Z.
template <class Change>
void writeChanged(const std::filesystem::path& file, Change&& change) {
    Imf::Header header(kWindow, kWindow);
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    change(header);
    std::vector<float> pixels(kPixels, 2.0f);
    Imf::FrameBuffer buffer;
    buffer.insert("Z", Imf::Slice::Make(Imf::FLOAT, pixels.data(), kWindow));
    Imf::OutputFile output(file.c_str(), header);
    output.setFrameBuffer(buffer);
    output.writePixels(kHeight);
}

TEST(ExrVariants, PartsOfOneSize_AreOneFrame) {
    const TemporaryFolder folder;
    writeParts(folder / "a.exr", {{"beauty", "R", 1}, {"depth", "Z", 2}, {"matte", "R", 3}});
    const ExrPlanes exr = readAll(folder / "a.exr");
    EXPECT_EQ(exr.width, kWidth);
    EXPECT_EQ(exr.height, kHeight);
    EXPECT_THAT(exr.planes, ElementsAre(Key("R"), Key("Z"), Key("matte.R")));
    EXPECT_EQ(exr.planes.at("R"), std::vector<float>(kPixels, 1.0f));
    EXPECT_EQ(exr.planes.at("Z"), std::vector<float>(kPixels, 2.0f));
    EXPECT_EQ(exr.planes.at("matte.R"), std::vector<float>(kPixels, 3.0f));
    EXPECT_THAT(exr.attributes,
                ElementsAre(Key("made by beauty"), Key("made by depth"), Key("made by matte")));
}

TEST(ExrVariants, TruncatedParts_AreRefused) {
    const TemporaryFolder folder;
    writeParts(folder / "a.exr", {{"beauty", "R", 1}, {"depth", "Z", 2}});
    const std::string whole = readFile(folder / "a.exr");
    for (size_t length = 0; length < whole.size(); ++length) {
        writeFile(folder / "cut.exr", whole.substr(0, length));
        EXPECT_THROW(readAll(folder / "cut.exr"), InputError) << length << " of " << whole.size() << " bytes";
    }
}

TEST(ExrVariants, PartsOfDifferentViews_AreRefused) {
    const TemporaryFolder folder;
    writeParts(folder / "a.exr", {{"large", "R", 1}, {"small", "Z", 2, Imath::Box2i({0, 0}, {3, 2})}});
    EXPECT_THAT(errorOf(folder / "a.exr"), HasSubstr("has parts of 10 x 5 and 4 x 3 pixels"));
    writeParts(folder / "b.exr", {{"l", "R", 1, kWindow, "left"}, {"r", "R", 2, kWindow, "right"}});
    EXPECT_THAT(errorOf(folder / "b.exr"),
                HasSubstr("is a stereo picture: it has the views 'left' and 'right'"));
    writeChanged(folder / "c.exr", [](Imf::Header& header) { Imf::addMultiView(header, {"left", "right"}); });
    EXPECT_THAT(errorOf(folder / "c.exr"), HasSubstr("is a stereo picture"));
}

TEST(ExrVariants, Ripmap_FinestLevelIsRead) {
    const TemporaryFolder folder;
    Imf::Header header(kWindow, kWindow);
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(4, 4, Imf::RIPMAP_LEVELS));
    {
        Imf::TiledOutputFile output((folder / "a.exr").c_str(), header);
        for (int y = 0; y < output.numYLevels(); ++y)
            for (int x = 0; x < output.numXLevels(); ++x) {
                std::vector<float> pixels(kPixels, static_cast<float>(10 * y + x));
                Imf::FrameBuffer buffer;
                buffer.insert("Z",
                              Imf::Slice::Make(Imf::FLOAT, pixels.data(), output.dataWindowForLevel(x, y)));
                output.setFrameBuffer(buffer);
                output.writeTiles(0, output.numXTiles(x) - 1, 0, output.numYTiles(y) - 1, x, y);
            }
    }
    EXPECT_EQ(readAll(folder / "a.exr").planes.at("Z"), std::vector<float>(kPixels, 0.0f));
}

TEST(ExrVariants, DeepPixels_AreRefused) {
    const TemporaryFolder folder;
    Imf::Header header(kWindow, kWindow);
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    std::vector<uint32_t> counts(kPixels, 1);
    std::vector<float> values(kPixels, 1.0f);
    std::vector<float*> pointers;
    for (float& value : values)
        pointers.push_back(&value);
    Imf::DeepFrameBuffer buffer;
    buffer.insertSampleCountSlice(Imf::Slice::Make(Imf::UINT, counts.data(), kWindow));
    buffer.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers.data()), sizeof(float*),
                                      sizeof(float*) * kWidth, sizeof(float)));
    {
        Imf::DeepScanLineOutputFile output((folder / "a.exr").c_str(), header);
        output.setFrameBuffer(buffer);
        output.writePixels(kHeight);
    }
    EXPECT_THAT(errorOf(folder / "a.exr"), HasSubstr("is a deep image; expected flat pixels"));
}

TEST(ExrVariants, EnvironmentMap_IsRefused) {
    const TemporaryFolder folder;
    writeChanged(folder / "a.exr", [](Imf::Header& header) { Imf::addEnvmap(header, Imf::ENVMAP_LATLONG); });
    EXPECT_THAT(errorOf(folder / "a.exr"), HasSubstr("is an environment map (lat-long)"));
}

TEST(ExrVariants, SubsampledChannel_IsRefusedOnlyIfRequested) {
    const TemporaryFolder folder;
    const Imath::Box2i window({0, 0}, {255, 255});
    Imf::Header header(window, window);
    header.compression() = Imf::NO_COMPRESSION; // so that the file is no longer than its pixels
    header.channels().insert("Z", Imf::Channel(Imf::HALF));
    header.channels().insert("BY", Imf::Channel(Imf::FLOAT, 2, 2));
    std::vector<half> depth(256 * 256, half(2.0f));
    std::vector<float> chroma(128 * 128, 1.0f);
    Imf::FrameBuffer buffer;
    buffer.insert("Z", Imf::Slice::Make(Imf::HALF, depth.data(), window));
    buffer.insert("BY", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(chroma.data()), sizeof(float),
                                   sizeof(float) * 128, 2, 2));
    {
        Imf::OutputFile output((folder / "a.exr").c_str(), header);
        output.setFrameBuffer(buffer);
        output.writePixels(256);
    }
    const auto onlyDepth = [](const std::vector<std::string>&) { return std::vector<std::string>{"Z"}; };
    EXPECT_EQ(readExr(folder / "a.exr", onlyDepth).planes.at("Z"), std::vector<float>(256 * 256, 2.0f));
    EXPECT_THAT(errorOf(folder / "a.exr"), HasSubstr("channel 'BY' is subsampled"));
}

/// Inserts an attribute with a claimed size of `size` bytes before all others.
std::string withAttribute(std::string bytes, int32_t size) {
    std::string attribute("aaa\0string\0", 11);
    attribute.append(reinterpret_cast<const char*>(&size), 4);
    return bytes.insert(8, attribute);
}

TEST(ExrVariants, GigabyteHeader_IsRefusedBeforeAllocation) {
    const TemporaryFolder folder;
    writeChanged(folder / "a.exr", [](Imf::Header&) {});
    const std::string bytes = readFile(folder / "a.exr");
    for (const int32_t size : {2147483647, 17 << 20}) {
        // A sparse file of that length, so that the file's size doesn't reveal the false claim.
        writeFile(folder / "b.exr", withAttribute(bytes, size));
        std::filesystem::resize_file(folder / "b.exr", uint64_t(4) << 30);
        rusage before{}, after{};
        getrusage(RUSAGE_SELF, &before);
        EXPECT_THAT(errorOf(folder / "b.exr"), HasSubstr("has a header of more than 16 MB: attribute 'aaa'"));
        getrusage(RUSAGE_SELF, &after);
        EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 8 << 10) << "kilobytes";
    }
    writeFile(folder / "b.exr", withAttribute(bytes, -1));
    EXPECT_THAT(errorOf(folder / "b.exr"), HasSubstr("damaged header: attribute 'aaa'"));
}

/// The library allocates the claimed chunk table: for 2^30 tiles of one pixel, 8 GB.
TEST(ExrVariants, TooManyTiles_AreRefused) {
    const TemporaryFolder folder;
    const Imath::Box2i window({0, 0}, {4095, 4095});
    Imf::Header header(window, window);
    header.compression() = Imf::RLE_COMPRESSION;
    header.channels().insert("Z", Imf::Channel(Imf::HALF));
    header.setTileDescription(Imf::TileDescription(4096, 4096));
    std::vector<half> pixels(4096 * 4096, half(1.0f));
    Imf::FrameBuffer buffer;
    buffer.insert("Z", Imf::Slice::Make(Imf::HALF, pixels.data(), window));
    {
        Imf::TiledOutputFile output((folder / "a.exr").c_str(), header);
        output.setFrameBuffer(buffer);
        output.writeTile(0, 0);
    }
    std::string bytes = readFile(folder / "a.exr");
    const size_t value = bytes.find(std::string("tiles\0tiledesc\0", 15)) + 15 + 4;
    const uint32_t one = 1;
    std::memcpy(&bytes[value], &one, 4);
    std::memcpy(&bytes[value + 4], &one, 4);
    writeFile(folder / "b.exr", bytes);
    EXPECT_EQ(readAll(folder / "a.exr").width, 4096);
    EXPECT_THAT(errorOf(folder / "b.exr"), HasSubstr("is truncated"));
}

TEST(ExrVariants, DamagedParts_AreReadOrRefused) {
    const TemporaryFolder folder;
    writeParts(folder / "a.exr", {{"beauty", "R", 1}, {"depth", "Z", 2}});
    const std::string whole = readFile(folder / "a.exr");
    std::mt19937 random(5);
    int refused = 0;
    for (size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(random());
        writeFile(folder / "damaged.exr", damaged);
        refused += !worksOrIsRefused([&] { readAll(folder / "damaged.exr"); });
    }
    EXPECT_GT(refused, 100); // most of a small file is header and tables
}

} // namespace
} // namespace plumbline
