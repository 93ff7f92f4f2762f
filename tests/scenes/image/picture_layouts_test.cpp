// Pictures stored in ways that OpenImageIO reads but doesn't write: written here byte by byte.
#include "scenes/image/image_file.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <zlib.h>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    EXPECT_EQ(compress(reinterpret_cast<Bytef*>(result.data()), &size,
                       reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
              Z_OK);
    result.resize(size);
    return result;
}

std::string littleEndian(uint32_t value, int bytes) {
    std::string text;
    for (int k = 0; k < bytes; ++k)
        text += static_cast<char>(value >> (8 * k));
    return text;
}

/// TIFF 6.0, section 2: a tag and its numbers, of 2 or 4 bytes each.
struct Field {
    uint32_t tag;
    int bytes;
    std::vector<uint32_t> values;
};

constexpr uint32_t kStripOffsets = 273;

/// `fields`: in the order of their tags, without the offsets of the strips, which are found here.
std::string tiff(std::vector<Field> fields, const std::vector<std::string>& strips) {
    const auto after = std::find_if(fields.begin(), fields.end(),
                                    [](const Field& field) { return field.tag > kStripOffsets; });
    auto& offsets = fields.insert(after, {kStripOffsets, 4, std::vector<uint32_t>(strips.size())})->values;
    const auto head = [&] {
        const size_t directoryEnd = 8 + 2 + 12 * fields.size() + 4;
        std::string directory = littleEndian(static_cast<uint32_t>(fields.size()), 2), behind;
        for (const Field& field : fields) {
            std::string values;
            for (const uint32_t value : field.values)
                values += littleEndian(value, field.bytes);
            directory += littleEndian(field.tag, 2) + littleEndian(field.bytes == 2 ? 3 : 4, 2) +
                         littleEndian(static_cast<uint32_t>(field.values.size()), 4);
            if (values.size() > 4) {
                directory += littleEndian(static_cast<uint32_t>(directoryEnd + behind.size()), 4);
                behind += values;
            } else {
                directory += (values + std::string(4, '\0')).substr(0, 4);
            }
        }
        return "II" + littleEndian(42, 2) + littleEndian(8, 4) + directory + littleEndian(0, 4) + behind;
    };
    auto at = static_cast<uint32_t>(head().size());
    std::string data;
    for (size_t k = 0; k < strips.size(); ++k) {
        offsets[k] = at + static_cast<uint32_t>(data.size());
        data += strips[k];
    }
    return head() + data;
}

uint32_t valueAt(int x, int y, int channel) {
    return static_cast<uint32_t>(x * 7 + y * 3 + channel * 50) % 256;
}

struct Layout {
    int channels, rowsPerStrip, bits;
    bool compressed, planar;
};

constexpr int kWidth = 31, kHeight = 150;

std::string writeLayout(const Layout& layout) {
    std::vector<std::string> strips;
    std::vector<uint32_t> sizes;
    for (int plane = 0; plane < (layout.planar ? layout.channels : 1); ++plane)
        for (int top = 0; top < kHeight; top += layout.rowsPerStrip) {
            std::string rows;
            for (int y = top; y < std::min(kHeight, top + layout.rowsPerStrip); ++y)
                for (int x = 0; x < kWidth; ++x)
                    for (int c = layout.planar ? plane : 0; c < (layout.planar ? plane + 1 : layout.channels);
                         ++c)
                        rows +=
                            littleEndian(valueAt(x, y, c) * (layout.bits == 16 ? 257 : 1), layout.bits / 8);
            strips.push_back(layout.compressed ? deflated(rows) : rows);
            sizes.push_back(static_cast<uint32_t>(strips.back().size()));
        }
    const auto channels = static_cast<uint32_t>(layout.channels);
    std::vector<Field> fields{{256, 4, {kWidth}},
                              {257, 4, {kHeight}},
                              {258, 2, std::vector(channels, static_cast<uint32_t>(layout.bits))},
                              {259, 2, {layout.compressed ? 8u : 1u}},
                              {262, 2, {channels >= 3 ? 2u : 1u}},
                              {277, 2, {channels}},
                              {278, 4, {static_cast<uint32_t>(layout.rowsPerStrip)}},
                              {279, 4, sizes},
                              {284, 2, {layout.planar ? 2u : 1u}}};
    if (channels == 2 || channels == 4) fields.push_back({338, 2, {2}}); // the last one is alpha
    return tiff(fields, strips);
}

TEST(PictureLayout, Strips_AreReadInEveryArrangement) {
    const TemporaryFolder folder;
    for (const int channels : {1, 2, 3, 4})
        for (const int rows : {1, 7, 64, 100, kHeight, 200})
            for (const int bits : {8, 16})
                for (const bool compressed : {true, false})
                    for (const bool planar : {true, false}) {
                        const std::string what = fmt::format("{} channels, {} rows, {} bits, {} {}", channels,
                                                             rows, bits, compressed, planar);
                        writeFile(folder / "a.tif", writeLayout({channels, rows, bits, compressed, planar}));
                        const Image image = readImage(folder / "a.tif");
                        ASSERT_EQ(image.channels, channels) << what;
                        for (int y = 0; y < kHeight; ++y)
                            for (int x = 0; x < kWidth; ++x)
                                for (int c = 0; c < channels; ++c)
                                    ASSERT_EQ(image.at(x, y, c), static_cast<float>(valueAt(x, y, c) / 255.0))
                                        << what << ", (" << x << ", " << y << ")";
                    }
}

TEST(PictureLayout, StripsLongerThanThePicture_AreReadOrRefused) {
    const TemporaryFolder folder;
    for (const int rows : {1 << 16, 1 << 30, 0x7fffffff, -1}) // -1: 2^32 - 1, one strip for all
        for (const bool compressed : {true, false})
            for (const bool planar : {true, false}) {
                std::string bytes = writeLayout({3, kHeight, 8, compressed, planar});
                const std::string field = littleEndian(278, 2) + littleEndian(4, 2) + littleEndian(1, 4);
                const size_t at = bytes.find(field + littleEndian(kHeight, 4));
                ASSERT_NE(at, std::string::npos);
                bytes.replace(at + field.size(), 4, littleEndian(static_cast<uint32_t>(rows), 4));
                writeFile(folder / "a.tif", bytes);
                const std::string message =
                    messageOf<InputError>([&] { EXPECT_EQ(readImage(folder / "a.tif").height, kHeight); });
                EXPECT_TRUE(rows == 1 << 16 ? message.empty() : message.find("is damaged or") == message.npos)
                    << rows << ": " << message;
            }
}

TEST(PictureLayout, TruncatedPlanarFile_IsRefused) {
    const TemporaryFolder folder;
    const std::string whole = writeLayout({3, 7, 8, true, true});
    for (size_t percent = 5; percent < 100; percent += 9) {
        writeFile(folder / "a.tif", whole.substr(0, whole.size() * percent / 100));
        EXPECT_NE(inputErrorOf([&] { readImage(folder / "a.tif"); }), "") << percent;
    }
}

/// A row of 4 texels in a strip, uncompressed.
std::string tinyTiff(uint32_t bits, uint32_t photometric, const std::string& bytes) {
    std::vector<Field> fields{
        {256, 2, {4}},           {257, 2, {1}}, {258, 2, {bits}}, {259, 2, {1}},
        {262, 2, {photometric}}, {277, 2, {1}}, {278, 2, {1}},    {279, 4, {uint32_t(bytes.size())}}};
    if (photometric == 3) { // a palette: red, green and blue of each entry
        std::vector<uint32_t> colors;
        for (int channel = 0; channel < 3; ++channel)
            for (uint32_t entry = 0; entry < 1u << bits; ++entry)
                colors.push_back(entry * (65535 / ((1u << bits) - 1)));
        fields.push_back({320, 2, colors});
    }
    return tiff(fields, {bytes});
}

TEST(PictureLayout, FewBitsAndPalettes_AreReadByTheirMeaning) {
    const TemporaryFolder folder;
    const auto values = [&](const std::string& bytes) {
        writeFile(folder / "a.tif", bytes);
        return readImage(folder / "a.tif").values;
    };
    EXPECT_THAT(values(tinyTiff(1, 1, "\x50")), ElementsAre(0, 1, 0, 1));
    EXPECT_THAT(values(tinyTiff(2, 1, "\x1b")), ElementsAre(0, 85 / 255.f, 170 / 255.f, 1));
    EXPECT_THAT(values(tinyTiff(4, 1, std::string("\x01\x5f", 2))),
                ElementsAre(0, 17 / 255.f, 85 / 255.f, 1));
    EXPECT_THAT(values(tinyTiff(8, 0, std::string("\0\xff\0\xff", 4))), ElementsAre(1, 0, 1, 0));
    EXPECT_THAT(values(tinyTiff(8, 3, std::string("\0\x33\x66\xff", 4))),
                ElementsAre(0, 0, 0, 0.2f, 0.2f, 0.2f, 0.4f, 0.4f, 0.4f, 1, 1, 1));
}

std::string chunk(const std::string& typeAndData) {
    const auto bigEndian = [](uint32_t value) {
        const std::string reversed = littleEndian(value, 4);
        return std::string(reversed.rbegin(), reversed.rend());
    };
    return bigEndian(static_cast<uint32_t>(typeAndData.size() - 4)) + typeAndData +
           bigEndian(static_cast<uint32_t>(
               crc32(0, reinterpret_cast<const Bytef*>(typeAndData.data()), uInt(typeAndData.size()))));
}

/// PNG specification, 11.2: `head` has depth, color type, compression, filter and interlace method.
std::string png(int width, int height, const std::string& head, const std::string& palette,
                const std::string& rows) {
    return "\x89PNG\r\n\x1a\n" +
           chunk(std::string("IHDR\0\0\0", 7) + static_cast<char>(width) + std::string(3, '\0') +
                 static_cast<char>(height) + head) +
           (palette.empty() ? "" : chunk("PLTE" + palette)) + chunk("IDAT" + deflated(rows)) + chunk("IEND");
}

TEST(PictureLayout, InterlacedAndPalettePng_AreRead) {
    const TemporaryFolder folder;
    constexpr int kSide = 20;
    // The seven passes of Adam7: first column and row, steps of columns and rows.
    constexpr int kPasses[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                   {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    std::string rows;
    for (const auto& [x0, y0, dx, dy] : kPasses)
        for (int y = y0; y < kSide; y += dy) {
            rows += '\0'; // no filter
            for (int x = x0; x < kSide; x += dx)
                rows += std::string(2, static_cast<char>(valueAt(x, y, 0)));
        }
    writeFile(folder / "a.png", png(kSide, kSide, std::string("\x10\0\0\0\1", 5), "", rows));
    const Image image = readImage(folder / "a.png");
    ASSERT_EQ(image.values.size(), 400u);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            ASSERT_EQ(image.at(x, y, 0), static_cast<float>(valueAt(x, y, 0) / 255.0)) << x << " " << y;

    writeFile(folder / "b.png", png(4, 1, std::string("\4\3\0\0\0", 5), std::string("\0\0\0\x33\x66\xff", 6),
                                    std::string("\0\x01\x10", 3)));
    EXPECT_THAT(readImage(folder / "b.png").values,
                ElementsAre(0, 0, 0, 0.2f, 0.4f, 1, 0.2f, 0.4f, 1, 0, 0, 0));
}

} // namespace
} // namespace plumbline
