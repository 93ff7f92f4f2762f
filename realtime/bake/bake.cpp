#include "realtime/bake/bake.h"

#include "realtime/bake/bake_kinds.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline {
namespace {

constexpr int kMaxSlices = 1024;

BakeKind coneKind(std::string_view name, std::string_view meaning, std::string_view source,
                  decltype(BakeKind::make) make) {
    return {.name = name,
            .meaning = meaning,
            .source = source,
            .slices = "0: cones at texel centers, as published; 1: cones valid for every point of the cell "
                      "between texels (i, j) and (i + 1, j + 1)",
            .channels = "ratio: st length per relief depth, at most 1",
            .needsScale = false,
            .make = make,
            .sliceNames = {"texel", "cell"}};
}

BakeKind quadConeKind() {
    BakeKind kind = coneKind("cone_step_quad", "Conservative cones by quadrant of the ray's direction in st",
                             "Policarpo, Oliveira, GPU Gems 3, section 18.3, 2007", bakeQuadConeMap);
    kind.channels = "ratios toward +s, -s, +t, -t: st length per relief depth, at most 1";
    return kind;
}

const std::vector<BakeKind>& table() {
    static const std::vector<BakeKind> kinds{
        {.name = "normal",
         .meaning = "Unit normal of the relief at the centers of texels, and its depth",
         .source = "Premecz, Iterative parallax mapping with slope information, 2006, section 3",
         .slices = "one",
         .channels = "normal along s, along t and out of the surface; relief depth",
         .needsScale = true,
         .make = bakeNormalMap,
         .channelNames = {"n.X", "n.Y", "n.Z", "D"}},
        {.name = "distance_field",
         .meaning = "Distance to the relief from boxes of st and depth, in relief depths",
         .source = "Premecz 2006, section 2.4; exact by Felzenszwalb and Huttenlocher, 2012",
         .slices = "depths k / slices to (k + 1) / slices",
         .channels = "least distance between the box and one the relief reaches, a lower bound; distance "
                     "between centers",
         .needsScale = true,
         .make = bakeDistanceField,
         .channelNames = {"box", "center"},
         .takesSlices = true},
        coneKind("cone_step", "Conservative cones: no point of the relief lies inside",
                 "Policarpo, Oliveira, GPU Gems 3, section 18.3, 2007", bakeConeMap),
        quadConeKind(),
        coneKind("cone_step_relaxed",
                 "Relaxed cones: a ray that starts outside, at any depth, never leaves the relief inside",
                 "Policarpo, Oliveira, GPU Gems 3, section 18.4, 2007; the criterion is this project's "
                 "(realtime/bake/cone_map.h)",
                 bakeRelaxedConeMap),
        coneKind("cone_step_relaxed_2007",
                 "Relaxed cones as published: valid only for rays that start at depth 0",
                 "Policarpo, Oliveira, GPU Gems 3, listing 18-2, 2007", bakeRelaxedConeMap2007),
        {.name = "max_mipmap",
         .meaning = "Bounds of the relief over blocks of 2^k x 2^k bilinear patches, level k of a pyramid",
         .source = "Tevs, Ihrke, Seidel, Maximum mipmaps for fast, accurate, and scalable dynamic height "
                   "field rendering, I3D 2008",
         .slices = "one",
         .channels = "least depth, most depth",
         .needsScale = false,
         .make = bakeMaxMipmap,
         .channelNames = {"least", "most"}},
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
