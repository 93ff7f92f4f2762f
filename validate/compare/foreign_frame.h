// A frame from an EXR of any renderer: channels by foreign_layout.h, values turned to what the channel table
// says, and in words what was assumed on the way. Frames that this program wrote are taken as they are; of
// others with our channel names the depths are looked through, and a missing coverage is made.
#pragma once

#include "scenes/frame/frame.h"
#include "scenes/scene/camera.h"
#include "validate/compare/foreign_layout.h"

#include <filesystem>

namespace plumbline {

/// Named like ours, values still theirs; metadata as in the file.
struct ForeignFrame {
    std::string file;
    Frame frame;
    ChannelPlan plan;
};

/// Throws InputError as readExr and planChannels do.
ForeignFrame readForeignFrame(const std::filesystem::path& file, std::span<const ChannelMapping> mappings);

/// Turns the values of `foreign` to ours; returns what was assumed, a sentence each.
///
/// Depth: a distance along the ray becomes planar with the camera; where there are positions as well, depth
/// is to come from those (compare.h). Coverage: where the file has none, or one that says nothing about the
/// surface (Blender's), a pixel is covered where its depth is finite, > 0 and none of the values that stand
/// for "nothing" (1e10, and the largest half 65504); without a depth, where the position isn't (0, 0, 0). A
/// covered pixel without such a depth stays covered, its depth infinite. Positions, of the known renderers or
/// mapped: in our world, in one with Z up (Blender's importers turn a mesh), or in pbrt's camera space; that
/// in which they lie on their pixels' rays is taken, for normals too. Throws InputError for distances without
/// a camera, and positions that lie on the rays in none of these spaces.
std::vector<std::string> settleFrame(ForeignFrame& foreign, const std::optional<Camera>& camera);

} // namespace plumbline
