// The kinds of baked maps and the function that bakes them.
//
// A technique's manifest names kinds under `inputs`; `plumbline bake` takes one as `--kind`. Bakers only use
// a height map, no scene and no OpenGL. They run on all threads, and their results are bit-identical for any
// number of threads.
#pragma once

#include "realtime/bake/baked_map.h"
#include "scenes/maps/height_map.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// Extent of one tile of the relief in world units, which maps texture space to world space. All kinds that
/// need it depend only on the ratios.
struct BakeScale {
    double s = 1, t = 1; // of one map width, one map height
    double depth = 1;    // of relief depth 1
    bool operator==(const BakeScale&) const = default;
};

struct BakeRequest {
    std::string kind;
    BakeScale scale; // only for kinds with needsScale
    int slices = 64; // of a distance field: slices of equal depth
    bool operator==(const BakeRequest&) const = default;
};

struct BakeKind {
    std::string_view name;
    std::string_view meaning, source; // one sentence; paper and section
    std::string_view slices;          // contents of slice k
    std::string_view channels;        // contents of channel k, with units
    bool needsScale;
    BakedMap (*make)(const HeightMap&, const BakeRequest&); // arguments checked by bakeMap
    /// Names in the image that `plumbline bake` writes. Slices without a name are numbered; the only one has
    /// none.
    std::vector<std::string_view> channelNames = {"R", "G", "B", "A"}, sliceNames = {};
    bool takesSlices = false; // uses BakeRequest::slices
    int version = 1; // of the baker: incremented when its values change, which invalidates cached maps
};
std::span<const BakeKind> bakeKinds();
/// Throws InputError that lists the kinds.
const BakeKind& bakeKind(std::string_view name);
bool isBakeKind(std::string_view name);

/// Throws InputError for an unknown kind, a scale that isn't positive and finite, slices outside [1, 1024];
/// MachineError if the map doesn't fit into memory.
BakedMap bakeMap(const HeightMap& map, const BakeRequest& request);

} // namespace plumbline
