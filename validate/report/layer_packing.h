// Packs planes of numbers as text that a script can contain. page/src/layer_unpacking.ts unpacks it.
//
// Bytes of equal significance are stored together, the most significant first, and each byte is replaced by
// its difference from the one before (as TIFF's predictor 3, Adobe Photoshop TIFF Technical Note 3, 2005),
// because neighboring values are similar. The result is compressed by zlib (RFC 1950) and encoded in base64
// (RFC 4648).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plumbline::report {

/// Every bit of the floats is kept, those of NaN too.
std::string packFloats(std::span<const float> values);
std::string packWords(std::span<const uint16_t> values);
std::string packBytes(std::vector<uint8_t> bytes);

/// With padding, without line breaks.
std::string base64(std::span<const uint8_t> bytes);

} // namespace plumbline::report
