#include "bake.h"

#include "../../scenes/error.h"
#include "bake_kinds.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline {
namespace {

constexpr int kMostSlices = 1024;

const std::vector<BakeKind>& table() {
    static const std::vector<BakeKind> kinds{
        {"max_mipmap", "Bounds of the relief over blocks of 2^k x 2^k bilinear patches, level k of a pyramid",
         "Tevs, Ihrke, Seidel, Maximum mipmaps for fast, accurate, and scalable dynamic height field "
         "rendering, I3D 2008",
         "one", "least depth, most depth", false, bakeMaxMipmap},
        {"normal", "Unit normal of the relief at the centres of texels, and its depth",
         "Premecz, Iterative parallax mapping with slope information, 2006, section 3", "one",
         "normal along s, along t and out of the surface; relief depth", true, bakeNormalMap},
        {"distance_field", "Distance to the relief from boxes of st and depth, in relief depths",
         "Premecz 2006, section 2.4; exact by Felzenszwalb and Huttenlocher, 2012",
         "depths k / slices to (k + 1) / slices",
         "least distance between the box and one the relief reaches, a lower bound; distance between centres",
         true, bakeDistanceField, true},
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
    if (request.slices < 1 || request.slices > kMostSlices)
        throw InputError(kind.name, fmt::format("{} slices", request.slices),
                         fmt::format("1 to {}", kMostSlices));
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
    throw InputError("bake", fmt::format("no kind of map is called '{}'", name), listOf(names),
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
