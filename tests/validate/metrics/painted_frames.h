// Frames painted by hand, small enough to verify every count of a test on paper.
#pragma once

#include "scenes/frame/frame.h"
#include "validate/metrics/frame_pair.h"

#include <numeric>
#include <string>
#include <vector>

namespace plumbline::test {

inline const std::vector<std::string> kLights{"sun"};

/// A frame without surfaces: every channel that metrics read, at its miss value.
inline Frame emptyFrame(int width, int height) {
    Frame frame(width, height);
    for (const char* name :
         {"R", "G", "B", "A", "Z", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "st.S", "st.T", "id"})
        frame.add(name);
    for (const std::string& light : kLights)
        frame.add(shadowChannel(light));
    return frame;
}

inline void set(Frame& frame, const char* channel, int x, int y, float value) {
    frame.channel(
        channel)[static_cast<size_t>(y) * static_cast<size_t>(frame.width()) + static_cast<size_t>(x)] =
        value;
}

/// Paints one covered pixel: lit, facing +z, st at the center of the first tile.
inline void paintPixel(Frame& frame, int x, int y, int id, float depth) {
    set(frame, "id", x, y, static_cast<float>(id));
    set(frame, "A", x, y, 1);
    set(frame, "Z", x, y, depth);
    for (const char* name : {"N.X", "N.Y", "P.X", "P.Y"})
        set(frame, name, x, y, 0);
    set(frame, "P.Z", x, y, -depth);
    set(frame, "N.Z", x, y, 1);
    set(frame, "st.S", x, y, 0.5f);
    set(frame, "st.T", x, y, 0.5f);
    for (const std::string& light : kLights)
        set(frame, shadowChannel(light).c_str(), x, y, 0);
}

/// Adds the channels of uncertainty, with no pixel uncertain.
inline void addUncertainty(Frame& frame) {
    frame.add("uncertain");
    for (const std::string& light : kLights)
        frame.add(uncertainShadowChannel(light));
}

/// Paints columns [x0, x1) of rows [y0, y1).
inline void paintRectangle(Frame& frame, int x0, int y0, int x1, int y1, int id = 1, float depth = 2) {
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            paintPixel(frame, x, y, id, depth);
}

inline ObjectInfo objectWithRelief(int id, double reliefDepth) {
    ObjectInfo object;
    object.id = id;
    object.name = "object " + std::to_string(id);
    object.reliefDepth = reliefDepth;
    object.map = ObjectInfo::Map{100, 50, true, true};
    return object;
}

/// Selects every object of a pair.
inline std::vector<size_t> allOf(const FramePair& pair) {
    std::vector<size_t> all(pair.objects().size());
    std::iota(all.begin(), all.end(), size_t(0));
    return all;
}

inline Frame flippedHorizontally(const Frame& frame) {
    Frame flipped(frame.width(), frame.height());
    const auto width = static_cast<size_t>(frame.width());
    for (const std::string& name : frame.channelNames()) {
        const auto from = frame.channel(name);
        const auto to = flipped.add(name);
        for (size_t i = 0; i < from.size(); ++i)
            to[i / width * width + (width - 1 - i % width)] = from[i];
    }
    return flipped;
}

inline Frame flippedVertically(const Frame& frame) {
    Frame flipped(frame.width(), frame.height());
    const auto width = static_cast<size_t>(frame.width()), height = static_cast<size_t>(frame.height());
    for (const std::string& name : frame.channelNames()) {
        const auto from = frame.channel(name);
        const auto to = flipped.add(name);
        for (size_t i = 0; i < from.size(); ++i)
            to[(height - 1 - i / width) * width + i % width] = from[i];
    }
    return flipped;
}

/// The frame moved right by one pixel. The first column becomes empty, the last one is lost.
inline Frame shiftedRight(const Frame& frame) {
    Frame shifted(frame.width(), frame.height());
    const auto width = static_cast<size_t>(frame.width());
    for (const std::string& name : frame.channelNames()) {
        const auto from = frame.channel(name);
        const auto to = shifted.add(name); // at its miss value
        for (size_t i = 0; i < from.size(); ++i)
            if (i % width > 0) to[i] = from[i - 1];
    }
    return shifted;
}

} // namespace plumbline::test
