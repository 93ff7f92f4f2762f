// Prints values of a frame for comparison with those in the page: frame_pixel FILE CHANNEL X Y [X Y …]. One
// line per pixel, in the shortest decimal that reads back as the same float. X from the left, Y from the top.
#include "scenes/core/error.h"
#include "tests/read_frame.h"

#include <fmt/format.h>

#include <cstdlib>
#include <exception>

int main(int argc, char** argv) {
    if (argc < 5 || argc % 2 == 0) {
        fmt::print(stderr, "usage: frame_pixel FILE CHANNEL X Y [X Y ...]\n");
        return 2;
    }
    try {
        const plumbline::Frame frame = plumbline::readFrame(argv[1]);
        const std::span<const float> plane = frame.channel(argv[2]);
        for (int i = 3; i + 1 < argc; i += 2) {
            const int x = std::atoi(argv[i]), y = std::atoi(argv[i + 1]);
            if (x < 0 || y < 0 || x >= frame.width() || y >= frame.height()) {
                fmt::print(stderr, "{}, {} is outside of {} x {}\n", x, y, frame.width(), frame.height());
                return 2;
            }
            fmt::print(
                "{}\n",
                plane[static_cast<size_t>(y) * static_cast<size_t>(frame.width()) + static_cast<size_t>(x)]);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
    return 0;
}
