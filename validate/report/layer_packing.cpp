#include "validate/report/layer_packing.h"

#include <bit>
#include <stdexcept>
#include <zlib.h>

namespace plumbline::report {

std::string base64(std::span<const uint8_t> bytes) {
    constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t at = 0; at < bytes.size(); at += 3) {
        const size_t left = bytes.size() - at;
        const uint32_t group = uint32_t(bytes[at]) << 16 | uint32_t(left > 1 ? bytes[at + 1] : 0) << 8 |
                               uint32_t(left > 2 ? bytes[at + 2] : 0);
        text += kLetters[group >> 18];
        text += kLetters[group >> 12 & 63];
        text += left > 1 ? kLetters[group >> 6 & 63] : '=';
        text += left > 2 ? kLetters[group & 63] : '=';
    }
    return text;
}

std::string packBytes(std::vector<uint8_t> bytes) {
    for (size_t at = bytes.size(); at-- > 1;)
        bytes[at] = static_cast<uint8_t>(bytes[at] - bytes[at - 1]);
    // Level 4 takes half the time of the default and gives 4 % larger data.
    constexpr int kLevel = 4;
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<uint8_t> packed(size);
    if (compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), kLevel) != Z_OK)
        throw std::runtime_error("zlib can't pack a plane");
    return base64(std::span(packed).first(size));
}

std::string packFloats(std::span<const float> values) {
    std::vector<uint8_t> bytes(4 * values.size());
    for (size_t at = 0; at < values.size(); ++at) {
        const auto bits = std::bit_cast<uint32_t>(values[at]);
        for (size_t byte = 0; byte < 4; ++byte)
            bytes[byte * values.size() + at] = static_cast<uint8_t>(bits >> (24 - 8 * byte));
    }
    return packBytes(std::move(bytes));
}

std::string packWords(std::span<const uint16_t> values) {
    std::vector<uint8_t> bytes(2 * values.size());
    for (size_t at = 0; at < values.size(); ++at) {
        bytes[at] = static_cast<uint8_t>(values[at] >> 8);
        bytes[values.size() + at] = static_cast<uint8_t>(values[at]);
    }
    return packBytes(std::move(bytes));
}

} // namespace plumbline::report
