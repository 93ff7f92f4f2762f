// The boundary between the program and the module plumbline_images, which alone is linked to OpenImageIO.
// Plain C entry points and callbacks: nothing crosses it that depends on a C++ library, and no exception
// does.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// What the reader hands a picture to, row by row, the top row first. All calls come from the reader's
/// thread.
struct PlumblinePictureSink {
    void* user;
    /// Called once before any row. `integer`: stored as 8 or 16-bit integers. Returns false to stop.
    bool (*begin)(void* user, int width, int height, int channels, bool integer);
    /// `count` values, interleaved in the order R G B A (or Y, or Y A). Returns false to stop.
    bool (*values)(void* user, const float* values, size_t count);
    /// At most once, last: why the picture can't be read. A begin() or values() that returned false isn't
    /// reported.
    void (*fail)(void* user, const char* what);
};

using PlumblineReadPicture = void(const char* file, const PlumblinePictureSink* sink);

/// `rgb`: width x height x 3, the top row first. On failure calls `fail` once.
using PlumblineWritePng = void(const char* file, int width, int height, const uint8_t* rgb, void* user,
                               void (*fail)(void* user, const char* what));
}

namespace plumbline {
/// Pixels a picture may have: 1 Gpixel.
inline constexpr int64_t kMostPicturePixels = int64_t(1) << 30;
} // namespace plumbline
