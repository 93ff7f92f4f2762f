// The bakers, one per kind; bake.cpp has the table of kinds.
#pragma once

#include "realtime/bake/bake.h"

namespace plumbline {

BakedMap bakeNormalMap(const HeightMap& map, const BakeRequest& request);
BakedMap bakeConeMap(const HeightMap& map, const BakeRequest& request);
BakedMap bakeQuadConeMap(const HeightMap& map, const BakeRequest& request);
BakedMap bakeRelaxedConeMap(const HeightMap& map, const BakeRequest& request);
BakedMap bakeRelaxedConeMap2007(const HeightMap& map, const BakeRequest& request);
BakedMap bakeDistanceField(const HeightMap& map, const BakeRequest& request);
BakedMap bakeMaxMipmap(const HeightMap& map, const BakeRequest& request);

} // namespace plumbline
