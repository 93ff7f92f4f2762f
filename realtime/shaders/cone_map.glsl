// Cone ratios: st distance per unit of relief depth of a cone above a point of the relief that a ray may
// cross in one step (realtime/bake/cone_map.h). Each function counts the texels it reads as lookups; bilinear
// counts as one.
//
// Slice 0 has the ratio at each texel center; slice 1 has a ratio valid in the whole cell between four texel
// centers. There is one channel, or one for each of the directions +s, -s, +t, -t.

uniform sampler2DArray uConeMap;

const int kTexelSlice = 0, kCellSlice = 1;

// The ratio of the cell that contains st, which is conservative for the bilinear relief.
vec4 coneOfCell(vec2 st) {
    ++gBakedLookups;
    return texelFetch(uConeMap, ivec3(cellOf(st), kCellSlice), 0);
}

// The ratio of the texel nearest to st. Not conservative: at a cliff, half of the cell at its foot is nearest
// to the texel on its top.
vec4 coneOfNearestTexel(vec2 st) {
    ++gBakedLookups;
    return texelFetch(uConeMap, ivec3(cellOf(st + 0.5 / vec2(reliefMapSize())), kTexelSlice), 0);
}

// Bilinear interpolation between texels, as with hardware filtering. Not conservative: the result can be
// wider than a valid cone (TECHNIQUES E20).
vec4 coneBilinear(vec2 st) {
    ++gBakedLookups;
    TexelCorners c = texelCorners(st);
    vec4 lower = mix(texelFetch(uConeMap, ivec3(c.low, kTexelSlice), 0),
                     texelFetch(uConeMap, ivec3(c.high.x, c.low.y, kTexelSlice), 0), c.weight.x);
    vec4 upper = mix(texelFetch(uConeMap, ivec3(c.low.x, c.high.y, kTexelSlice), 0),
                     texelFetch(uConeMap, ivec3(c.high, kTexelSlice), 0), c.weight.x);
    return mix(lower, upper, c.weight.y);
}

// The smallest ratio of the four texels around st.
vec4 coneMinOfFour(vec2 st) {
    gBakedLookups += 4;
    TexelCorners c = texelCorners(st);
    return min(min(texelFetch(uConeMap, ivec3(c.low, kTexelSlice), 0),
                   texelFetch(uConeMap, ivec3(c.high.x, c.low.y, kTexelSlice), 0)),
               min(texelFetch(uConeMap, ivec3(c.low.x, c.high.y, kTexelSlice), 0),
                   texelFetch(uConeMap, ivec3(c.high, kTexelSlice), 0)));
}
