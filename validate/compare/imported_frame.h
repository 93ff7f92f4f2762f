// Imports a frame from an EXR of any renderer: channels are recognized by imported_layout.h, values are
// converted to those of the channel table, and the assumptions made are returned as sentences. Frames that
// this program wrote aren't changed. In other frames with our channel names, invalid depths are replaced and
// missing coverage is derived.
#pragma once

#include "scenes/frame/frame.h"
#include "scenes/scene/camera.h"
#include "validate/compare/imported_layout.h"

#include <filesystem>

namespace plumbline {

/// Channels have our names, values aren't converted yet; metadata as in the file.
struct ImportedFrame {
    std::string file;
    Frame frame;
    ChannelPlan plan;
};

/// Throws InputError as readExr and planChannels do.
ImportedFrame readImportedFrame(const std::filesystem::path& file, std::span<const ChannelMapping> mappings);

/// Converts the values of `imported` to ours; returns the assumptions made, a sentence each.
///
/// Depth: a distance along the ray is converted to planar depth with the camera. If the frame also has
/// positions, the distance is removed and compare.h computes the depth from the positions.
/// Coverage: if the file has none, or one that is 1 on the background too (Blender), a pixel is covered where
/// its depth is finite, > 0 and not one of the values that mean "no surface" (1e10, and the largest half
/// 65504); without depth, where its position isn't (0, 0, 0). A covered pixel without such a depth stays
/// covered and gets an infinite depth.
/// Positions of a known renderer, or mapped ones, may be in our world, in one with Z up (Blender's importers
/// rotate a mesh), or in pbrt's camera space. The space in which they lie on the rays of their pixels is
/// chosen, for normals too. Throws InputError for distances without a camera, and for positions that lie on
/// the rays in none of these spaces.
std::vector<std::string> convertFrame(ImportedFrame& imported, const std::optional<Camera>& camera);

} // namespace plumbline
