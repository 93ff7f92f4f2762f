// Maps the channels of another renderer's EXR to ours, by their names only; imported_frame.h converts the
// values.
//
// Recognized, besides frames with our own channel names:
//   Blender 3.4, multilayer   LAYER.Depth.Z (planar; 1e10 where there is no surface), .Normal .Position .UV
//                             .IndexOB .Combined
//   Mitsuba 3, aov            PREFIX.T (distance along the ray), the others by the names in the manual: nn or
//                             sh_normal, position or pos, uv
//   pbrt-v4, gbuffer          P.X P.Y P.Z, Ns.X Ns.Y Ns.Z, u, v; no depth, no coverage
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plumbline {

/// A --map option, or the equivalent for a channel whose name is recognized.
struct ChannelMapping {
    std::string theirs, ours; // ours: a name of the channel table; "Z" for distances too
    bool byUser = false;
    bool negated = false;
    /// If set, the channel contains distances along the ray from a plane this far in front of the camera,
    /// world units.
    std::optional<double> distanceFrom{};
};

/// Parses texts "THEIRS=OURS", where OURS is a channel of the table, "-" and a channel, "distance" or
/// "distance+NEAR". Throws InputError, also if a channel of ours is mapped twice.
std::vector<ChannelMapping> parseChannelMap(std::span<const std::string> texts);

enum class FrameLayout { Own, Blender, Mitsuba, Pbrt };
/// For a sentence: "a frame of Blender".
const char* nameOf(FrameLayout layout);

struct ChannelPlan {
    FrameLayout layout = FrameLayout::Own;
    std::map<std::string, ChannelMapping> channels; // by our name
};

/// `names`: all channels of the file. Throws InputError, located at `where`, if a mapped channel doesn't
/// exist, two channels could be the same one of ours, or no channel is recognized.
ChannelPlan planChannels(std::span<const std::string> names, std::span<const ChannelMapping> mappings,
                         const std::string& where);

} // namespace plumbline
