#include "scenes/image/picture_check.h"

#include "scenes/core/error.h"
#include "scenes/core/read_file.h"

#include <cstdint>
#include <string_view>
#include <zlib.h>

namespace plumbline {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kJpegStart = "\xff\xd8";

uint8_t byteAt(std::string_view bytes, size_t i) {
    return static_cast<uint8_t>(bytes[i]);
}

uint32_t bigEndian32(std::string_view bytes, size_t i) {
    return uint32_t(byteAt(bytes, i)) << 24 | uint32_t(byteAt(bytes, i + 1)) << 16 |
           uint32_t(byteAt(bytes, i + 2)) << 8 | byteAt(bytes, i + 3);
}

/// The checksum of a PNG chunk's type and data (PNG specification, 5.5).
uint32_t checksumOf(std::string_view bytes) {
    return static_cast<uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

enum class Wholeness { Whole, Truncated, Damaged };

/// PNG specification, 5.3: length, type, data, checksum of type and data; the last chunk is IEND.
Wholeness checkPng(std::string_view bytes) {
    for (size_t chunk = kPngSignature.size();;) {
        if (chunk + 12 > bytes.size()) return Wholeness::Truncated;
        const size_t length = bigEndian32(bytes, chunk);
        if (length > bytes.size() - chunk - 12) return Wholeness::Truncated;
        const std::string_view typeAndData = bytes.substr(chunk + 4, 4 + length);
        if (checksumOf(typeAndData) != bigEndian32(bytes, chunk + 8 + length)) return Wholeness::Damaged;
        if (typeAndData.substr(0, 4) == "IEND") return Wholeness::Whole;
        chunk += 12 + length;
    }
}

/// ITU T.81, annex B: marker segments up to the end-of-image marker. An embedded thumbnail's end-of-image
/// marker is inside a segment and is skipped.
Wholeness checkJpeg(std::string_view bytes) {
    for (size_t i = kJpegStart.size(); i + 1 < bytes.size();) {
        const uint8_t marker = byteAt(bytes, i + 1);
        const bool restart = marker >= 0xd0 && marker <= 0xd7;
        if (byteAt(bytes, i) != 0xff || marker == 0x00 || marker == 0xff || restart) {
            ++i; // entropy-coded data with stuffed zeros and restart markers, or fill bytes
        } else if (marker == 0xd9) {
            return Wholeness::Whole;
        } else {
            if (i + 3 >= bytes.size()) return Wholeness::Truncated;
            i += 2 + (size_t(byteAt(bytes, i + 2)) << 8 | byteAt(bytes, i + 3));
        }
    }
    return Wholeness::Truncated;
}

} // namespace

void checkPictureIsWhole(const std::filesystem::path& file) {
    const std::string bytes = readWholeFile(file);
    const bool png = std::string_view(bytes).starts_with(kPngSignature);
    const bool jpeg = std::string_view(bytes).starts_with(kJpegStart);
    const Wholeness wholeness = png ? checkPng(bytes) : jpeg ? checkJpeg(bytes) : Wholeness::Whole;
    const char* expected = png ? "a whole PNG file" : "a whole JPEG file";
    if (wholeness == Wholeness::Truncated) throw InputError(file.string(), "is truncated", expected);
    if (wholeness == Wholeness::Damaged)
        throw InputError(file.string(), "is damaged: a checksum is wrong", expected);
}

} // namespace plumbline
