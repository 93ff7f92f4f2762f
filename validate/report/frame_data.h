// The planes of a frame that the page shows, packed as text. page/src/layer_unpacking.ts unpacks it.
#pragma once

#include "validate/compare/compare.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::report {

/// A packed frame: a JSON object with a member for each layer, and the names of the layers in order.
struct FrameData {
    std::vector<std::string> layers;
    std::string json;
};

/// Color, object, depth, shadows, uncertain pixels. `depth`: planar, empty if there is none.
FrameData packReference(const FramePair& pair, std::span<const float> depth);

/// Color, object, depth, angle to the reference's normal, shadows, lookups and iterations of the test frame.
FrameData packTest(const FramePair& pair, std::span<const float> depth);

/// One layer of counts.
FrameData packCounts(const std::string& layer, const std::vector<uint16_t>& counts);

inline constexpr std::string_view kFrameScriptBeginning = "plumblineFrame(";
/// The script that passes a frame to the page: a call of plumblineFrame(). `file`: as in FrameEntry.
std::string frameScript(const std::string& file, const FrameData& frame);

} // namespace plumbline::report
