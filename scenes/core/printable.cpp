#include "scenes/core/printable.h"

#include <cstdint>

namespace plumbline {
namespace {

struct Character {
    uint32_t code = 0;
    size_t bytes = 0; // 0: not UTF-8
};

uint32_t byteAt(std::string_view text, size_t i) {
    return static_cast<unsigned char>(text[i]);
}

/// The first character of a text that isn't empty (RFC 3629, section 4: no overlong forms, no surrogates).
Character firstCharacter(std::string_view text) {
    const uint32_t lead = byteAt(text, 0);
    if (lead < 0x80) return {lead, 1};
    const size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
    uint32_t code = lead & (0x7fu >> bytes);
    for (size_t i = 1; i < bytes; ++i) {
        if ((byteAt(text, i) & 0xc0) != 0x80) return {};
        code = code << 6 | (byteAt(text, i) & 0x3f);
    }
    const uint32_t least = bytes == 4 ? 0x10000 : bytes == 3 ? 0x800 : 0x80;
    if (code < least || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return {};
    return {code, bytes};
}

bool isShown(uint32_t code) {
    const auto within = [&](uint32_t first, uint32_t last) { return code >= first && code <= last; };
    const bool control = code < 0x20 || within(0x7f, 0x9f);
    const bool separator = within(0x2028, 0x2029);
    // Unicode, annex 9, table 4, and the marks of section 2.6.
    const bool direction =
        within(0x202a, 0x202e) || within(0x2066, 0x2069) || within(0x200e, 0x200f) || code == 0x061c;
    return !control && !separator && !direction;
}

} // namespace

std::string printable(std::string_view text) {
    constexpr std::string_view kReplacement = "\xef\xbf\xbd"; // U+FFFD
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Character character = firstCharacter(text);
        const size_t bytes = character.bytes == 0 ? 1 : character.bytes;
        if (character.bytes == 0)
            result += kReplacement;
        else if (isShown(character.code))
            result += text.substr(0, bytes);
        else
            result += ' ';
        text.remove_prefix(bytes);
    }
    return result;
}

} // namespace plumbline
