#include "realtime/bake/bake.h"

#include "realtime/bake/bake_kinds.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline {
namespace {

constexpr int kMaxSlices = 1024;
constexpr std::string_view kConeSlices =
    "0: cones at texel centers, as published; 1: cones valid for every point of the cell between texels "
    "(i, j) and (i + 1, j + 1)";

const std::vector<BakeKind>& table() {
    static const std::vector<BakeKind> kinds{
        {"normal", "Unit normal of the relief at the centers of texels, and its depth",
         "Premecz, Iterative parallax mapping with slope information, 2006, section 3", "one",
         "normal along s, along t and out of the surface; relief depth", true, bakeNormalMap},
        {"distance_field", "Distance to the relief from boxes of st and depth, in relief depths",
         "Premecz 2006, section 2.4; exact by Felzenszwalb and Huttenlocher, 2012",
         "depths k / slices to (k + 1) / slices",
         "least distance between the box and one the relief reaches, a lower bound; distance between centers",
         true, bakeDistanceField, true},
        {"cone_step", "Conservative cones: no point of the relief lies inside",
         "Policarpo, Oliveira, GPU Gems 3, section 18.3, 2007", kConeSlices,
         "ratio: st length per relief depth, at most 1", false, bakeConeMap},
        {"cone_step_quad", "Conservative cones by quadrant of the ray's direction in st",
         "Policarpo, Oliveira, GPU Gems 3, section 18.3, 2007", kConeSlices,
         "ratios toward +s, -s, +t, -t: st length per relief depth, at most 1", false, bakeQuadConeMap},
        {"cone_step_relaxed",
         "Relaxed cones: a ray that starts outside, at any depth, never leaves the relief inside",
         "Policarpo, Oliveira, GPU Gems 3, section 18.4, 2007; the criterion is this project's "
         "(realtime/bake/cone_map.h)",
         kConeSlices, "ratio: st length per relief depth, at most 1", false, bakeRelaxedConeMap},
        {"cone_step_relaxed_2007", "Relaxed cones as published: valid only for rays that start at depth 0",
         "Policarpo, Oliveira, GPU Gems 3, listing 18-2, 2007", kConeSlices,
         "ratio: st length per relief depth, at most 1", false, bakeRelaxedConeMap2007},
        {"max_mipmap", "Bounds of the relief over blocks of 2^k x 2^k bilinear patches, level k of a pyramid",
         "Tevs, Ihrke, Seidel, Maximum mipmaps for fast, accurate, and scalable dynamic height field "
         "rendering, I3D 2008",
         "one", "least depth, most depth", false, bakeMaxMipmap},
    };
    return kinds;
}

void checkRequest(const BakeKind& kind, const BakeRequest& request) {
    for (const double extent : {request.scale.s, request.scale.t, request.scale.depth})
        if (kind.needsScale && !(std::isfinite(extent) && extent > 0))
            throw InputError(kind.name,
                             fmt::format("a tile of {} x {} world units, {} deep", request.scale.s,
                                         request.scale.t, request.scale.depth),
                             "three numbers above 0");
    if (request.slices < 1 || request.slices > kMaxSlices)
        throw InputError(kind.name, fmt::format("{} slices", request.slices),
                         fmt::format("1 to {}", kMaxSlices));
}

} // namespace

std::span<const BakeKind> bakeKinds() {
    return table();
}

bool isBakeKind(std::string_view name) {
    for (const BakeKind& kind : table())
        if (kind.name == name) return true;
    return false;
}

const BakeKind& bakeKind(std::string_view name) {
    std::vector<std::string> names;
    for (const BakeKind& kind : table()) {
        if (kind.name == name) return kind;
        names.emplace_back(kind.name);
    }
    throw InputError("bake", fmt::format("unknown kind of map '{}'", name), listOf(names),
                     didYouMean(name, names));
}

BakedMap bakeMap(const HeightMap& map, const BakeRequest& request) {
    const BakeKind& kind = bakeKind(request.kind);
    checkRequest(kind, request);
    BakedMap baked = kind.make(map, request);
    baked.kind = request.kind;
    return baked;
}

} // namespace plumbline
