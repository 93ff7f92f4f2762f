// Cone ratios: st distance per unit of relief depth in which nothing of the relief stands in the cone above a point
// (realtime/bake/cone_map.h). Each function is counted by the texels it reads.
//
// Slice 0 holds the ratio of each texel's center, slice 1 one that holds everywhere between four texels. One channel, or
// four of them: toward +s, -s, +t, -t.

uniform sampler2DArray uConeMap;

const int kTexelSlice = 0, kCellSlice = 1;

// The ratio of the cell st lies in: conservative for the bilinear relief.
vec4 coneOfCell(vec2 st) {
    ++gBakedLookups;
    return texelFetch(uConeMap, ivec3(cellOf(st), kCellSlice), 0);
}

// The texel nearest to st. Half of a cliff's foot is nearest to its top.
vec4 coneOfNearestTexel(vec2 st) {
    ++gBakedLookups;
    return texelFetch(uConeMap, ivec3(cellOf(st + 0.5 / vec2(reliefMapSize())), kTexelSlice), 0);
}

// Bilinear between texels, as a sampler would: wider than the cones around it allow (TECHNIQUES E20).
vec4 coneBilinear(vec2 st) {
    ++gBakedLookups;
    TexelCorners c = texelCorners(st);
    vec4 lower = mix(texelFetch(uConeMap, ivec3(c.low, kTexelSlice), 0),
                     texelFetch(uConeMap, ivec3(c.high.x, c.low.y, kTexelSlice), 0), c.weight.x);
    vec4 upper = mix(texelFetch(uConeMap, ivec3(c.low.x, c.high.y, kTexelSlice), 0),
                     texelFetch(uConeMap, ivec3(c.high, kTexelSlice), 0), c.weight.x);
    return mix(lower, upper, c.weight.y);
}

// The narrowest of the four texels around st.
vec4 coneMinOfFour(vec2 st) {
    gBakedLookups += 4;
    TexelCorners c = texelCorners(st);
    return min(min(texelFetch(uConeMap, ivec3(c.low, kTexelSlice), 0),
                   texelFetch(uConeMap, ivec3(c.high.x, c.low.y, kTexelSlice), 0)),
               min(texelFetch(uConeMap, ivec3(c.low.x, c.high.y, kTexelSlice), 0),
                   texelFetch(uConeMap, ivec3(c.high, kTexelSlice), 0)));
}
