// Throw-away: the relief depth itself.
#include "realtime/bake/bake_kinds.h"

namespace plumbline {

BakedMap bakeThrowawayMap(const HeightMap& map, const BakeRequest&) {
    BakedMap baked;
    const auto depths = map.depths();
    baked.levels.push_back({map.width(), map.height(), {depths.begin(), depths.end()}});
    return baked;
}

} // namespace plumbline
