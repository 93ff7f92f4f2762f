// The interface between the program and the module plumbline_images, the only binary linked to OpenImageIO.
// It consists of C entry points and callbacks; neither C++ library types nor exceptions cross it.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// Receives an image row by row, top row first. All calls come from the reader's thread.
struct PlumblinePictureSink {
    void* user;
    /// Called once before any row. `integer`: stored as 8 or 16-bit integers. Returns false to stop.
    bool (*begin)(void* user, int width, int height, int channels, bool integer);
    /// `count` values, interleaved in the order R G B A (or Y, or Y A). Returns false to stop.
    bool (*values)(void* user, const float* values, size_t count);
    /// Called at most once, last, with the reason why the image can't be read. Not called if begin() or
    /// values() returned false.
    void (*fail)(void* user, const char* what);
};

using PlumblineReadPicture = void(const char* file, const PlumblinePictureSink* sink);

/// `rgb`: width x height x 3, the top row first. On failure calls `fail` once.
using PlumblineWritePng = void(const char* file, int width, int height, const uint8_t* rgb, void* user,
                               void (*fail)(void* user, const char* what));
}

namespace plumbline {
/// Largest number of pixels in an image: 1 Gpixel.
inline constexpr int64_t kMaxPicturePixels = int64_t(1) << 30;
} // namespace plumbline
