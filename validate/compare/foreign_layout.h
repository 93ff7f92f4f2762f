// Which channels of another renderer's EXR are which of ours, by their names alone; foreign_frame.h turns the
// values.
//
// Known by themselves, besides frames with our own names:
//   Blender 3.4, multilayer   LAYER.Depth.Z (planar; 1e10 where nothing is), .Normal .Position .UV .IndexOB
//   .Combined Mitsuba 3, aov            PREFIX.T (distance along the ray), and the manual's names for the
//   rest: nn or sh_normal, position or pos, uv pbrt-v4, gbuffer          P.X P.Y P.Z, Ns.X Ns.Y Ns.Z, u, v;
//   no depth, no coverage
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plumbline {

/// One --map, or what stands for one where the channel's name is known.
struct ChannelMapping {
    std::string theirs, ours; // ours: of the channel table; "Z" for distances too
    bool byUser = false;
    bool negated = false;
    /// Distances along the ray, from a plane so far in front of the camera; world units.
    std::optional<double> distanceFrom{};
};

/// Texts "THEIRS=OURS", OURS a channel of the table, "-" and a channel, "distance" or "distance+NEAR". Throws
/// InputError, also for a channel of ours that is named twice.
std::vector<ChannelMapping> parseChannelMap(std::span<const std::string> texts);

enum class FrameLayout { Own, Blender, Mitsuba, Pbrt };
/// As in a sentence: "a frame of Blender".
const char* nameOf(FrameLayout layout);

struct ChannelPlan {
    FrameLayout layout = FrameLayout::Own;
    std::map<std::string, ChannelMapping> channels; // by our name
};

/// `names`: all channels of the file. Throws InputError, with `where` in front, for a mapping of a channel
/// that isn't there, two channels that could be the same one of ours, or none that is any.
ChannelPlan planChannels(std::span<const std::string> names, std::span<const ChannelMapping> mappings,
                         const std::string& where);

} // namespace plumbline
