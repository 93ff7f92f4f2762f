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

/// Receives a picture's file.
struct PlumblineFileSink {
    void* user;
    /// Called once with all of its bytes, unless fail() is.
    void (*contents)(void* user, const uint8_t* bytes, size_t count);
    /// Called at most once, with the reason why there are none.
    void (*fail)(void* user, const char* what);
};

/// `rgb`: width x height x 3, the top row first.
using PlumblineEncodePng = void(int width, int height, const uint8_t* rgb, const PlumblineFileSink* sink);
}

namespace plumbline {
/// Largest number of pixels in an image: 1 Gpixel.
inline constexpr int64_t kMaxPicturePixels = int64_t(1) << 30;
/// The reason given to fail() when memory runs out.
inline constexpr const char* kOutOfMemory = "needs more memory than there is";
} // namespace plumbline
