// The kinds of baked maps, by name, and the one way to make them.
//
// A kind is what a technique's manifest asks for under `inputs` and `plumbline bake --kind` takes. Bakes see
// a height map alone, no scene and no OpenGL; they run on all threads and give the same bits on any number of
// them.
#pragma once

#include "realtime/bake/baked_map.h"
#include "scenes/maps/height_map.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// Extent of one tile of the relief, world units: what turns texture space into space. Only ratios matter to
/// every kind that asks for it.
struct BakeScale {
    double s = 1, t = 1; // of one map width, one map height
    double depth = 1;    // of relief depth 1
    bool operator==(const BakeScale&) const = default;
};

struct BakeRequest {
    std::string kind;
    BakeScale scale; // kinds with needsScale alone
    int slices = 64; // of a distance field: slices of equal depth
    bool operator==(const BakeRequest&) const = default;
};

struct BakeKind {
    std::string_view name;
    std::string_view meaning, source; // a sentence; paper and section
    std::string_view slices;          // what slice k holds
    std::string_view channels;        // what channel k holds, with units
    bool needsScale;
    BakedMap (*make)(const HeightMap&, const BakeRequest&); // arguments checked by bakeMap
    bool takesSlices = false;                               // BakeRequest::slices matters
    int version = 1; // of the builder: goes up when it gives other values than before, so that caches let go
};
std::span<const BakeKind> bakeKinds();
/// Throws InputError that lists the kinds.
const BakeKind& bakeKind(std::string_view name);
bool isBakeKind(std::string_view name);

/// Throws InputError for an unknown kind, a scale that isn't positive and finite, slices outside [1, 1024];
/// MachineError if the map doesn't fit into memory.
BakedMap bakeMap(const HeightMap& map, const BakeRequest& request);

} // namespace plumbline
