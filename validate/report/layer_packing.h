// Planes of numbers as text that a script can hold. src/layer_unpacking.ts of the page unpacks it.
//
// Bytes of equal weight stand side by side, the most significant first, and each byte is replaced by its
// difference to the one before (as TIFF's predictor 3, Adobe Photoshop TIFF Technical Note 3, 2005):
// neighbors are similar there. Then zlib (RFC 1950), then base64 (RFC 4648).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plumbline::report {

/// Every bit of the floats is kept, whatever they are.
std::string packFloats(std::span<const float> values);
std::string packWords(std::span<const uint16_t> values);
std::string packBytes(std::vector<uint8_t> bytes);

/// With padding, without line breaks.
std::string base64(std::span<const uint8_t> bytes);

} // namespace plumbline::report
