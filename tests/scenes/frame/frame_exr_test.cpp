#include "scenes/frame/frame_exr.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/read_frame.h"
#include "tests/temporary_folder.h"

#include <rapidcheck/gtest.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>
#include <ImfTiledOutputFile.h>
#include <algorithm>
#include <csignal>
#include <cstring>
#include <gmock/gmock.h>
#include <half.h>
#include <random>
#include <sys/resource.h>

namespace plumbline {
namespace {

using testing::HasSubstr;

uint32_t bits(float value) {
    uint32_t result;
    std::memcpy(&result, &value, sizeof result);
    return result;
}

void expectSameFrame(const Frame& a, const Frame& b) {
    ASSERT_EQ(a.width(), b.width());
    ASSERT_EQ(a.height(), b.height());
    ASSERT_EQ(a.channelNames(), b.channelNames());
    for (const std::string& name : a.channelNames())
        for (size_t i = 0; i < a.pixelCount(); ++i)
            ASSERT_EQ(bits(a.channel(name)[i]), bits(b.channel(name)[i])) << name << " pixel " << i;
    EXPECT_EQ(a.metadata, b.metadata);
}

/// Noise over 37 x 41 pixels (not a multiple of ZIP's 16 lines), with every special float.
Frame noisyFrame() {
    Frame frame(37, 41);
    std::mt19937 random(7);
    for (const char* name : {"A", "Z", "P.X", "shadow.sun"})
        for (float& value : frame.add(name))
            value = static_cast<float>(random()) / 4e9f;
    const float specials[] = {kInfinityF, -kInfinityF, kNanF, -kNanF, 0.0f, -0.0f, 1e-42f, 3.4e38f};
    std::copy(std::begin(specials), std::end(specials), frame.channel("Z").begin() + 100);
    frame.metadata = {{"program", "plumbline 0.1"}, {"empty", ""}, {"lines", "a\nb\t\"c\" äöü"}};
    return frame;
}

TEST(FrameExr, RoundTrip_KeepsBitsAndMetadata) {
    const TemporaryFolder folder;
    const Frame frame = noisyFrame();
    writeFrame(frame, folder / "a.exr");
    expectSameFrame(readFrame(folder / "a.exr"), frame);
    EXPECT_EQ(folder.fileCount(), 1u); // no temporary file is left
}

TEST(FrameExr, AnyThreadCount_GivesEqualBytes) {
    const TemporaryFolder folder;
    writeFrame(noisyFrame(), folder / "a.exr");
    for (const int threads : {0, 1, 4}) {
        Imf::setGlobalThreadCount(threads);
        writeFrame(noisyFrame(), folder / "b.exr");
        EXPECT_EQ(readFile(folder / "a.exr"), readFile(folder / "b.exr")) << threads << " threads";
    }
    // No date or other attribute of the moment.
    EXPECT_EQ(readFile(folder / "a.exr").find("apDate"), std::string::npos);
}

TEST(FrameExr, RowZero_IsTopRowOfFile) {
    const TemporaryFolder folder;
    Frame frame(2, 3);
    frame.add("Z")[0] = 5;
    writeFrame(frame, folder / "a.exr");
    Imf::InputFile file((folder / "a.exr").c_str());
    float line[2] = {};
    Imf::FrameBuffer buffer;
    buffer.insert("Z", Imf::Slice::Make(Imf::FLOAT, line, Imath::V2i(0), 2, 1, sizeof(float), sizeof line));
    file.setFrameBuffer(buffer);
    file.readPixels(0); // y = 0, which EXR draws at the top
    EXPECT_EQ(line[0], 5);
    EXPECT_EQ(line[1], kInfinityF);
}

/// Every strict beginning of a file lacks something, whatever the length.
TEST(FrameExr, TruncatedAnywhere_IsRefused) {
    const TemporaryFolder folder;
    Frame frame(20, 20); // 2 chunks
    frame.add("Z")[7] = 1;
    frame.add("A")[7] = 1;
    writeFrame(frame, folder / "whole.exr");
    const std::string whole = readFile(folder / "whole.exr");
    ASSERT_GT(whole.size(), 400u);
    for (size_t length = 0; length < whole.size(); ++length) {
        writeFile(folder / "cut.exr", whole.substr(0, length));
        EXPECT_THROW(readFrame(folder / "cut.exr"), InputError)
            << length << " of " << whole.size() << " bytes";
    }
}

TEST(FrameExr, DamagedAnywhere_IsReadOrRefused) {
    const TemporaryFolder folder;
    Frame frame(20, 20);
    frame.add("Z")[7] = 1;
    writeFrame(frame, folder / "whole.exr");
    const std::string whole = readFile(folder / "whole.exr");
    std::mt19937 random(3);
    int refused = 0;
    for (size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(random());
        writeFile(folder / "damaged.exr", damaged);
        refused += !worksOrIsRefused([&] { readFrame(folder / "damaged.exr"); });
    }
    EXPECT_GT(refused, 100); // most of a small file is header and tables
}

TEST(FrameExr, NoFrameFile_IsRefused) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { readFrame(folder / "none.exr"); }), HasSubstr("no such file"));
    EXPECT_THAT(inputErrorOf([&] { readFrame(folder.path()); }), HasSubstr("is a folder"));
    writeFile(folder / "text.exr", "not an image at all");
    EXPECT_THAT(inputErrorOf([&] { readFrame(folder / "text.exr"); }), HasSubstr("is not an OpenEXR file"));
}

TEST(FrameExr, UnwritablePlace_IsRefused) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { writeFrame(noisyFrame(), folder / "none" / "a.exr"); }),
                HasSubstr("does not exist"));
    EXPECT_THAT(inputErrorOf([&] { writeFrame(noisyFrame(), folder.path()); }),
                HasSubstr("not a regular file"));
    EXPECT_THROW(writeFrame(Frame(), folder / "a.exr"), InputError);
    Frame reserved = noisyFrame();
    reserved.metadata["dataWindow"] = "x";
    EXPECT_THAT(inputErrorOf([&] { writeFrame(reserved, folder / "a.exr"); }), HasSubstr("'dataWindow'"));
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(FrameExr, FullDisk_KeepsOldFile) {
    const TemporaryFolder folder;
    writeFile(folder / "a.exr", "old");
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = old;
    small.rlim_cur = 4096; // less than the frame
    setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(writeFrame(noisyFrame(), folder / "a.exr"), MachineError);
    setrlimit(RLIMIT_FSIZE, &old);
    EXPECT_EQ(readFile(folder / "a.exr"), "old");
    EXPECT_EQ(folder.fileCount(), 1u);
}

/// A file of another renderer: a half Z, a uint id and a float A, `window` its data and display window.
Imf::Header importedHeader(const Imath::Box2i& window) {
    Imf::Header header(window, window);
    header.channels().insert("Z", Imf::Channel(Imf::HALF));
    header.channels().insert("id", Imf::Channel(Imf::UINT));
    header.channels().insert("A", Imf::Channel(Imf::FLOAT));
    header.channels().insert("albedo.R", Imf::Channel(Imf::FLOAT)); // no channel of ours
    return header;
}

struct ImportedPixels {
    explicit ImportedPixels(const Imath::Box2i& window) {
        const auto count = static_cast<size_t>((window.size().x + 1) * (window.size().y + 1));
        for (size_t i = 0; i < count; ++i) {
            z.push_back(half(static_cast<float>(i) * 0.5f));
            id.push_back(static_cast<uint32_t>(i));
            a.push_back(i % 2 ? 1.0f : 0.0f);
        }
        buffer.insert("Z", Imf::Slice::Make(Imf::HALF, z.data(), window));
        buffer.insert("id", Imf::Slice::Make(Imf::UINT, id.data(), window));
        buffer.insert("A", Imf::Slice::Make(Imf::FLOAT, a.data(), window));
        buffer.insert("albedo.R", Imf::Slice::Make(Imf::FLOAT, a.data(), window));
    }
    std::vector<half> z;
    std::vector<uint32_t> id;
    std::vector<float> a;
    Imf::FrameBuffer buffer;
};

void expectImportedPixels(const Frame& frame, int width, int height) {
    ASSERT_EQ(frame.width(), width);
    ASSERT_EQ(frame.height(), height);
    EXPECT_THAT(frame.channelNames(), testing::UnorderedElementsAre("Z", "id", "A"));
    for (size_t i = 0; i < frame.pixelCount(); ++i) {
        ASSERT_EQ(frame.channel("Z")[i], static_cast<float>(i) * 0.5f);
        ASSERT_EQ(frame.channel("id")[i], static_cast<float>(i));
        ASSERT_EQ(frame.channel("A")[i], i % 2 ? 1.0f : 0.0f);
    }
}

TEST(FrameExr, HalfUintAndShiftedWindow_AreRead) {
    const TemporaryFolder folder;
    const Imath::Box2i window({-3, 10}, {6, 14}); // 10 x 5
    for (const auto compression : {Imf::NO_COMPRESSION, Imf::PIZ_COMPRESSION, Imf::RLE_COMPRESSION}) {
        Imf::Header header = importedHeader(window);
        header.compression() = compression;
        ImportedPixels pixels(window);
        {
            Imf::OutputFile file((folder / "a.exr").c_str(), header);
            file.setFrameBuffer(pixels.buffer);
            file.writePixels(5);
        }
        expectImportedPixels(readFrame(folder / "a.exr"), 10, 5);
    }
}

TEST(FrameExr, Tiles_AreRead) {
    const TemporaryFolder folder;
    const Imath::Box2i window({0, 0}, {39, 24});
    for (const auto mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS}) { // ripmaps: exr_variants_test.cpp
        Imf::Header header = importedHeader(window);
        header.setTileDescription(Imf::TileDescription(16, 16, mode));
        ImportedPixels pixels(window);
        {
            Imf::TiledOutputFile file((folder / "a.exr").c_str(), header);
            file.setFrameBuffer(pixels.buffer);
            for (int level = 0; level < file.numLevels();
                 ++level) // coarser ones get the same memory's first pixels
                file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
        }
        expectImportedPixels(readFrame(folder / "a.exr"), 40, 25);
        const std::string whole = readFile(folder / "a.exr");
        for (size_t length = 0; length < whole.size(); length += 37) {
            writeFile(folder / "cut.exr", whole.substr(0, length));
            // Coarser levels follow the finest: a file that lacks only some of those has all that is read.
            const bool read =
                worksOrIsRefused([&] { expectImportedPixels(readFrame(folder / "cut.exr"), 40, 25); });
            EXPECT_FALSE(read && mode == Imf::ONE_LEVEL) << length;
            EXPECT_FALSE(read && length < whole.size() / 2) << length;
        }
    }
}

TEST(FrameExr, Crops_AreRefused) {
    const TemporaryFolder folder;
    const Imath::Box2i window({0, 0}, {9, 4});
    ImportedPixels pixels(window);
    Imf::Header cropped = importedHeader(window);
    cropped.displayWindow() = Imath::Box2i({0, 0}, {19, 9});
    {
        Imf::OutputFile file((folder / "crop.exr").c_str(), cropped);
        file.setFrameBuffer(pixels.buffer);
        file.writePixels(5);
    }
    EXPECT_THAT(
        inputErrorOf([&] { readFrame(folder / "crop.exr"); }),
        HasSubstr("is cropped: its data window is 10 x 5 at (0, 0), its display window 20 x 10 at (0, 0)"));
}

/// Sets the four numbers of dataWindow and displayWindow in a file's header to (0, 0, right, bottom).
std::string withWindow(std::string bytes, int32_t right, int32_t bottom) {
    for (const char* name : {"dataWindow", "displayWindow"}) {
        const size_t value = bytes.find(name) + std::strlen(name) + 1 + 6 + 4; // name\0 box2i\0 size
        std::memcpy(&bytes[value + 8], &right, 4);
        std::memcpy(&bytes[value + 12], &bottom, 4);
    }
    return bytes;
}

TEST(FrameExr, HugeSize_IsRefusedBeforeAllocation) {
    const TemporaryFolder folder;
    Frame frame(4, 4);
    frame.add("Z");
    writeFrame(frame, folder / "a.exr");
    const std::string bytes = readFile(folder / "a.exr");
    const auto messageFor = [&](int32_t right, int32_t bottom) {
        writeFile(folder / "b.exr", withWindow(bytes, right, bottom));
        return inputErrorOf([&] { readFrame(folder / "b.exr"); });
    };
    EXPECT_THAT(messageFor(999999999, 9), HasSubstr("is 1000000000 x 10 pixels large"));
    EXPECT_THAT(messageFor(2147483647, 2147483647), HasSubstr("2147483648 x 2147483648"));
    EXPECT_THAT(messageFor(-5, 9), HasSubstr("empty data window"));
    // One chunk of 4 lines, as in the file, but 64 MB of pixels, which no few hundred bytes unpack to.
    EXPECT_THAT(messageFor((1 << 20) - 1, 3), HasSubstr("is truncated; expected"));
    EXPECT_THAT(messageFor(32767, 32767), HasSubstr("truncated")); // 4 GB can't be in a few hundred bytes
}

RC_GTEST_PROP(FrameExrProperty, RandomFrame_RoundTrips, ()) {
    static const TemporaryFolder folder;
    Frame frame(*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40));
    for (const char* name : {"Z", "id"})
        for (float& value : frame.add(name)) {
            const auto pattern = *rc::gen::arbitrary<uint32_t>();
            std::memcpy(&value, &pattern, sizeof value);
        }
    writeFrame(frame, folder / "a.exr");
    expectSameFrame(readFrame(folder / "a.exr"), frame);
}

} // namespace
} // namespace plumbline
