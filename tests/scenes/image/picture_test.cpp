// Images of all formats, written with OpenImageIO.
#include "scenes/frame/frame_exr.h"
#include "scenes/image/image_file.h"
#include "scenes/maps/map_file.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <gmock/gmock.h>
#include <random>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Writes interleaved values as `stored`; `values` in the units of that type (0..255 for UINT8).
template <class T>
void writePicture(const std::filesystem::path& file, int width, int height, int channels,
                  const std::vector<T>& values, OIIO::TypeDesc stored,
                  const std::map<std::string, int>& attributes = {}) {
    auto output = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(output) << OIIO::geterror();
    OIIO::ImageSpec spec(width, height, channels, stored);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("CompressionQuality", 100);
    for (const auto& [name, value] : attributes)
        spec.attribute(name, value);
    if (attributes.count("tile")) spec.tile_width = spec.tile_height = attributes.at("tile");
    ASSERT_TRUE(output->open(file.string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<T>::value, values.data())) << output->geterror();
    ASSERT_TRUE(output->close());
}

/// All values of an 8-bit channel, in a 16 x 16 picture with `channels` channels: channel c is value + 50 c
/// mod 256.
std::vector<uint8_t> all8Bit(int channels) {
    std::vector<uint8_t> values;
    for (int v = 0; v < 256; ++v)
        for (int c = 0; c < channels; ++c)
            values.push_back(static_cast<uint8_t>(v + 50 * c));
    return values;
}

TEST(Picture, EightBits_AreNearestFloatOfVOver255) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.tif"})
        for (const int channels : {1, 3, 4}) {
            writePicture(folder / name, 16, 16, channels, all8Bit(channels), OIIO::TypeDesc::UINT8);
            const Image image = readImage(folder / name);
            ASSERT_EQ(image.channels, channels) << name;
            ASSERT_EQ(image.width, 16);
            ASSERT_EQ(image.height, 16);
            EXPECT_TRUE(image.integer);
            for (int v = 0; v < 256; ++v)
                for (int c = 0; c < channels; ++c) // alpha varies too; colors must not be premultiplied
                    ASSERT_EQ(image.at(v % 16, v / 16, c), static_cast<float>((v + 50 * c) % 256 / 255.0))
                        << name << " " << v << " channel " << c;
        }
}

TEST(Picture, SixteenBits_AreNearestFloatOfVOver65535) {
    const TemporaryFolder folder;
    std::vector<uint16_t> values(256 * 256);
    for (size_t v = 0; v < values.size(); ++v)
        values[v] = static_cast<uint16_t>(v);
    for (const char* name : {"a.png", "a.tif"}) {
        writePicture(folder / name, 256, 256, 1, values, OIIO::TypeDesc::UINT16);
        const Image image = readImage(folder / name);
        EXPECT_TRUE(image.integer);
        for (size_t v = 0; v < values.size(); ++v)
            ASSERT_EQ(image.values[v], static_cast<float>(static_cast<double>(v) / 65535.0))
                << name << " " << v;
    }
}

TEST(Picture, Floats_AreUnchanged) {
    const TemporaryFolder folder;
    const std::vector<float> values{0, 0.1f, 1, -2, 1e30f, kInfinityF};
    for (const char* name : {"a.tif", "a.exr"}) {
        writePicture(folder / name, 2, 1, 3, values, OIIO::TypeDesc::FLOAT);
        const Image image = readImage(folder / name);
        EXPECT_FALSE(image.integer);
        EXPECT_EQ(image.values, values) << name;
    }
    writePicture(folder / "half.exr", 2, 1, 3, std::vector<float>{0, 0.5f, 1, 2, 3, 0.25f},
                 OIIO::TypeDesc::HALF);
    EXPECT_THAT(readImage(folder / "half.exr").values, ElementsAre(0, 0.5f, 1, 2, 3, 0.25f));
}

TEST(Picture, RadianceHdr_IsRead) {
    const TemporaryFolder folder;
    // A shared exponent and 8 bits a channel: powers of two survive exactly.
    writePicture(folder / "a.hdr", 2, 1, 3, std::vector<float>{0.5f, 0.25f, 1, 4, 8, 2},
                 OIIO::TypeDesc::FLOAT);
    const Image image = readImage(folder / "a.hdr");
    EXPECT_FALSE(image.integer);
    EXPECT_THAT(image.values, ElementsAre(0.5f, 0.25f, 1, 4, 8, 2));
}

TEST(Picture, Jpeg_IsCloseToWritten) {
    const TemporaryFolder folder;
    std::vector<uint8_t> ramp(64 * 64);
    for (size_t i = 0; i < ramp.size(); ++i)
        ramp[i] = static_cast<uint8_t>(i % 64 * 4);
    writePicture(folder / "a.jpg", 64, 64, 1, ramp, OIIO::TypeDesc::UINT8);
    const Image image = readImage(folder / "a.jpg");
    ASSERT_EQ(image.channels, 1);
    for (size_t i = 0; i < ramp.size(); ++i)
        ASSERT_NEAR(image.values[i], ramp[i] / 255.0, 2.5 / 255)
            << i; // quality 100: quantized to whole steps
}

TEST(Picture, TiledFile_FirstRowIsTop) {
    const TemporaryFolder folder;
    std::vector<uint8_t> values(40 * 40);
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<uint8_t>(i * 7);
    writePicture(folder / "a.tif", 40, 40, 1, values, OIIO::TypeDesc::UINT8, {{"tile", 16}});
    const Image image = readImage(folder / "a.tif");
    for (size_t i = 0; i < values.size(); ++i)
        ASSERT_EQ(image.values[i], static_cast<float>(values[i] / 255.0)) << i;
}

TEST(Picture, GrayAlphaAndExrNames_AreRead) {
    const TemporaryFolder folder;
    writePicture(folder / "ya.png", 1, 1, 2, std::vector<uint8_t>{51, 102}, OIIO::TypeDesc::UINT8);
    const Image image = readImage(folder / "ya.png");
    EXPECT_EQ(image.channels, 2);
    EXPECT_THAT(image.values, ElementsAre(0.2f, 0.4f));

    Frame frame(1, 1); // EXR sorts channels by name: A B G R
    frame.add("R")[0] = 1;
    frame.add("G")[0] = 2;
    frame.add("B")[0] = 3;
    frame.add("A")[0] = 4;
    writeFrame(frame, folder / "rgba.exr");
    EXPECT_THAT(readImage(folder / "rgba.exr").values, ElementsAre(1, 2, 3, 4));

    Frame single(1, 1);
    single.add("Z")[0] = 0.5f;
    writeFrame(single, folder / "z.exr");
    EXPECT_THAT(readImage(folder / "z.exr").values, ElementsAre(0.5f));

    Frame both(1, 1);
    both.add("Z");
    both.add("id");
    writeFrame(both, folder / "both.exr");
    EXPECT_THAT(inputErrorOf([&] { readImage(folder / "both.exr"); }), HasSubstr("has the channels Z or id"));
}

TEST(Picture, NoImageFile_IsRefused) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { readImage(folder / "none.png"); }), HasSubstr("no such file"));
    EXPECT_THAT(inputErrorOf([&] { readImage(folder.path()); }), HasSubstr("is not a file"));
    writeFile(folder / "empty.png", "");
    EXPECT_THAT(inputErrorOf([&] { readImage(folder / "empty.png"); }), HasSubstr("is empty"));
    writeFile(folder / "text.png", "This is no picture, whatever its name says.");
    EXPECT_THAT(inputErrorOf([&] { readImage(folder / "text.png"); }), HasSubstr("is not a picture"));
    writePicture(folder / "deep.tif", 1, 1, 1, std::vector<uint32_t>{7}, OIIO::TypeDesc::UINT32);
    EXPECT_THAT(inputErrorOf([&] { readImage(folder / "deep.tif"); }), HasSubstr("stores uint"));
}

TEST(Picture, WrongExtension_IsReadByContent) {
    const TemporaryFolder folder;
    writePicture(folder / "a.png", 1, 1, 1, std::vector<uint8_t>{51}, OIIO::TypeDesc::UINT8);
    std::filesystem::rename(folder / "a.png", folder / "a.jpg");
    EXPECT_THAT(readImage(folder / "a.jpg").values, ElementsAre(0.2f));
    Frame frame(1, 1);
    frame.add("Z")[0] = 3;
    writeFrame(frame, folder / "a.dat");
    EXPECT_THAT(readImage(folder / "a.dat").values, ElementsAre(3));
}

/// Noise, so that every byte of the file matters.
std::vector<uint8_t> noise(size_t count) {
    std::mt19937 random(11);
    std::vector<uint8_t> values(count);
    for (uint8_t& value : values)
        value = static_cast<uint8_t>(random());
    return values;
}

void writeNoise(const std::filesystem::path& file) {
    const bool floating = file.extension() == ".hdr" || file.extension() == ".exr";
    writePicture(file, 32, 32, 3, noise(32 * 32 * 3),
                 floating ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
}

TEST(Picture, Truncated_IsRefused) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.hdr", "a.exr"}) {
        writeNoise(folder / name);
        const std::string whole = readFile(folder / name);
        const std::filesystem::path cut = folder / ("cut" + std::filesystem::path(name).extension().string());
        for (size_t percent = 0; percent < 100; percent += 3) {
            writeFile(cut, whole.substr(0, whole.size() * percent / 100));
            const std::string message = inputErrorOf([&] { readImage(cut); });
            // Detected by our check before the library prints its own message; a file with only the first
            // bytes can't be recognized.
            const bool ours = (cut.extension() == ".png" || cut.extension() == ".jpg") && percent > 0;
            EXPECT_TRUE(!ours || message.find("is truncated; expected") != std::string::npos)
                << message << " cut to " << percent << " %";
        }
        // The last bytes may be padding or an optional trailer, but reading must not crash.
        for (size_t missing = 1; missing < 40; ++missing) {
            writeFile(cut, whole.substr(0, whole.size() - missing));
            worksOrIsRefused([&] { readImage(cut); });
        }
    }
}

TEST(Picture, Damaged_IsReadOrRefused) {
    const TemporaryFolder folder;
    std::mt19937 random(13);
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.hdr", "a.exr"}) {
        writeNoise(folder / name);
        const std::string whole = readFile(folder / name);
        for (int i = 0; i < 60; ++i) {
            std::string damaged = whole;
            for (int k = 0; k < 4; ++k) // mostly in the header
                damaged[random() % (k < 3 ? std::min<size_t>(200, damaged.size()) : damaged.size())] =
                    static_cast<char>(random());
            writeFile(folder / name, damaged);
            worksOrIsRefused([&] { readImage(folder / name); });
        }
    }
}

TEST(Picture, HugeSize_IsRefused) {
    const TemporaryFolder folder;
    writePicture(folder / "a.png", 1, 1, 1, std::vector<uint8_t>{0}, OIIO::TypeDesc::UINT8);
    std::string bytes = readFile(folder / "a.png");
    // IHDR: width and height, big-endian, at bytes 16 and 20, then 5 more bytes and a CRC-32 of all from
    // byte 12.
    const uint32_t side = 60000;
    for (const size_t at : {16u, 20u})
        for (size_t k = 0; k < 4; ++k)
            bytes[at + k] = static_cast<char>(side >> (24 - 8 * k));
    uint32_t crc = 0xffffffffu;
    for (size_t i = 12; i < 29; ++i) {
        crc ^= static_cast<uint8_t>(bytes[i]);
        for (int k = 0; k < 8; ++k)
            crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0);
    }
    for (size_t k = 0; k < 4; ++k)
        bytes[29 + k] = static_cast<char>(~crc >> (24 - 8 * k));
    writeFile(folder / "b.png", bytes);
    EXPECT_THAT(inputErrorOf([&] { readImage(folder / "b.png"); }), HasSubstr("60000 x 60000"));
}

TEST(WritePng, RoundTrip_GivesEqualBytes) {
    const TemporaryFolder folder;
    const std::vector<uint8_t> rgb = noise(5 * 3 * 3);
    writePng(folder / "a.png", 5, 3, rgb);
    writePng(folder / "b.png", 5, 3, rgb);
    EXPECT_EQ(readFile(folder / "a.png"), readFile(folder / "b.png"));
    const Image image = readImage(folder / "a.png");
    for (size_t i = 0; i < rgb.size(); ++i)
        ASSERT_EQ(image.values[i], static_cast<float>(rgb[i] / 255.0));
    EXPECT_EQ(folder.fileCount(), 2u);
    EXPECT_THAT(inputErrorOf([&] { writePng(folder / "none" / "a.png", 5, 3, rgb); }),
                HasSubstr("does not exist"));
    EXPECT_THROW(writePng(folder / "c.png", 5, 4, rgb), InputError);
    EXPECT_THROW(writePng(folder / "c.png", 0, 0, {}), InputError);
}

TEST(HeightMapFile, Heights_BecomeDepthsWithRowsFlipped) {
    const TemporaryFolder folder;
    writePicture(folder / "a.png", 2, 2, 1, std::vector<uint8_t>{0, 51, 102, 255}, OIIO::TypeDesc::UINT8);
    const HeightMap depth = readHeightMap(folder / "a.png", Stores::Depth);
    EXPECT_THAT(depth.depths(), ElementsAre(0.4f, 1, 0, 0.2f)); // the image's lower row first
    EXPECT_EQ(depth.depth({0.25, 0.75}), 0);                    // its top left texel
    const HeightMap height = readHeightMap(folder / "a.png", Stores::Height, Wrap::Clamp, Wrap::Repeat);
    EXPECT_THAT(height.depths(), ElementsAre(0.6f, 0, 1, 0.8f));
    EXPECT_EQ(height.wrapS(), Wrap::Clamp);
    EXPECT_EQ(height.wrapT(), Wrap::Repeat);
}

TEST(HeightMapFile, Colors_AreRefusedCompressionNoiseIsNot) {
    const TemporaryFolder folder;
    writePicture(folder / "a.png", 1, 1, 3, std::vector<uint8_t>{102, 110, 104}, OIIO::TypeDesc::UINT8);
    EXPECT_EQ(readHeightMap(folder / "a.png", Stores::Depth).depth({0, 0}), static_cast<double>(0.4f));
    writePicture(folder / "a.png", 1, 1, 3, std::vector<uint8_t>{102, 111, 104}, OIIO::TypeDesc::UINT8);
    EXPECT_THAT(inputErrorOf([&] { readHeightMap(folder / "a.png", Stores::Depth); }),
                HasSubstr("differ by up to 0.0353; expected a gray one (differences up to 0.0314)"));
    writePicture(folder / "a.png", 1, 1, 4, std::vector<uint8_t>{102, 102, 102, 0}, OIIO::TypeDesc::UINT8);
    EXPECT_EQ(readHeightMap(folder / "a.png", Stores::Depth).depth({0, 0}),
              static_cast<double>(0.4f)); // not alpha
}

TEST(HeightMapFile, OutOfRangeValues_AreCountedAndLocated) {
    const TemporaryFolder folder;
    writePicture(folder / "a.tif", 2, 2, 1, std::vector<float>{0, 1, 1.5f, kNanF}, OIIO::TypeDesc::FLOAT);
    EXPECT_THAT(
        inputErrorOf([&] { readHeightMap(folder / "a.tif", Stores::Height); }),
        HasSubstr(
            "2 of 4 texels are NaN or outside [0,1], the first is 1.5 at column 0, row 1 from the top"));
    writePicture(folder / "a.tif", 2, 1, 1, std::vector<float>{-1e-9f, 0}, OIIO::TypeDesc::FLOAT);
    EXPECT_THROW(readHeightMap(folder / "a.tif", Stores::Height), InputError);
}

TEST(ColorMapFile, Integers_AreSrgbFloatsLinear) {
    const TemporaryFolder folder;
    writePicture(folder / "a.png", 1, 2, 3, std::vector<uint8_t>{0, 255, 128, 10, 10, 10},
                 OIIO::TypeDesc::UINT8);
    const ColorMap map = readColorMap(folder / "a.png");
    // Lower row first. 10/255 = 0.039216 <= 0.04045, so / 12.92; (128/255 + 0.055)/1.055 to the 2.4 is
    // 0.21586.
    EXPECT_FLOAT_EQ(map.rgb[0], static_cast<float>(10 / 255.0 / 12.92));
    EXPECT_EQ(map.rgb[3], 0);
    EXPECT_EQ(map.rgb[4], 1);
    EXPECT_NEAR(map.rgb[5], 0.21586, 5e-6);
    writePicture(folder / "a.hdr", 1, 1, 3, std::vector<float>{0.5f, 0.25f, 2}, OIIO::TypeDesc::FLOAT);
    EXPECT_THAT(readColorMap(folder / "a.hdr").rgb, ElementsAre(0.5f, 0.25f, 2));
    writePicture(folder / "gray.png", 1, 1, 1, std::vector<uint8_t>{255}, OIIO::TypeDesc::UINT8);
    EXPECT_THAT(readColorMap(folder / "gray.png").rgb, ElementsAre(1, 1, 1));
    writePicture(folder / "a.tif", 1, 1, 3, std::vector<float>{0, kInfinityF, 0}, OIIO::TypeDesc::FLOAT);
    EXPECT_THAT(inputErrorOf([&] { readColorMap(folder / "a.tif"); }), HasSubstr("negative or not finite"));
}

TEST(HeightMapFile, PublicMaps_AreRead) {
    const std::filesystem::path folder = PLUMBLINE_SHARED_DATA;
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    const HeightMap toys = readHeightMap(folder / "toy_box_disp.png", Stores::Depth);
    EXPECT_EQ(toys.width(), 256);
    const HeightMap bricks = readHeightMap(folder / "bricks2_disp.jpg", Stores::Depth);
    EXPECT_EQ(bricks.width(), 512);
    EXPECT_THROW(readHeightMap(folder / "bricks2.jpg", Stores::Depth), InputError); // a color map
    EXPECT_EQ(readColorMap(folder / "spot_texture.png").width, 1024);
}

} // namespace
} // namespace plumbline
