// The relief depth d(s,t) in GLSL (C++ version and conventions: scenes/maps/height_map.h). A test checks that
// the two agree.

uniform sampler2D uHeightMap;   // R32F depths, row 0 = bottom
uniform ivec2 uHeightMapClamps; // along s, t: 1 clamp, 0 repeat

// Cost counters of this pixel: lookups of the height map and of baked maps by view and shadow rays, without
// the lookup for the normal's gradient; iterations of the view ray's search.
int gHeightLookups = 0;
int gBakedLookups = 0;
int gIterations = 0;

void countIteration() { ++gIterations; }

// Converts a coordinate to texels, with integers at texel centers.
float texelCoordinate(float s, int size, int clamps) {
    float unit = clamps != 0 ? clamp(s, -1.0, 2.0) : s - floor(s);
    return unit * float(size) - 0.5;
}

int wrapTexel(int i, int size, int clamps) {
    if (clamps == 0) i += i < 0 ? size : (i >= size ? -size : 0);
    return clamp(i, 0, size - 1); // under repeat, only affects NaN coordinates
}

ivec2 reliefMapSize() { return textureSize(uHeightMap, 0); }

// The two texels around st along each axis, wrapped, and the weights of the second texels.
struct TexelCorners {
    ivec2 low, high;
    vec2 weight;
};

TexelCorners texelCorners(vec2 st) {
    ivec2 size = reliefMapSize();
    vec2 texels = vec2(texelCoordinate(st.x, size.x, uHeightMapClamps.x),
                       texelCoordinate(st.y, size.y, uHeightMapClamps.y));
    ivec2 low = ivec2(floor(texels));
    TexelCorners corners;
    corners.low = ivec2(wrapTexel(low.x, size.x, uHeightMapClamps.x), wrapTexel(low.y, size.y, uHeightMapClamps.y));
    corners.high =
        ivec2(wrapTexel(low.x + 1, size.x, uHeightMapClamps.x), wrapTexel(low.y + 1, size.y, uHeightMapClamps.y));
    corners.weight = texels - floor(texels);
    return corners;
}

// The cell that contains st, wrapped: cell (i, j) is the bilinear patch between texels (i, j) and (i + 1, j +
// 1).
ivec2 cellOf(vec2 st) { return texelCorners(st).low; }

// Depths of the texels around st (00, 10, 01, 11) and the weights of the second texels.
struct TexelPatch {
    vec4 depths;
    vec2 weight;
};

float texelDepth(int i, int j) { return texelFetch(uHeightMap, ivec2(i, j), 0).r; }

TexelPatch texelPatch(vec2 st) {
    TexelCorners c = texelCorners(st);
    return TexelPatch(vec4(texelDepth(c.low.x, c.low.y), texelDepth(c.high.x, c.low.y), texelDepth(c.low.x, c.high.y),
                           texelDepth(c.high.x, c.high.y)),
                      c.weight);
}

// Relief depth at st; counts one lookup.
float reliefDepth(vec2 st) {
    ++gHeightLookups;
    if (kHardwareFilter) return textureLod(uHeightMap, st, 0.0).r;
    TexelPatch p = texelPatch(st);
    float lower = p.depths.x + (p.depths.y - p.depths.x) * p.weight.x;
    float upper = p.depths.z + (p.depths.w - p.depths.z) * p.weight.x;
    return lower + (upper - lower) * p.weight.y;
}

// Gradient of the depth per unit of s and t, of the exact bilinear patch whatever the filter. On the border
// between patches it is that of the patch to the right and above.
vec2 reliefDepthGradient(vec2 st) {
    TexelPatch p = texelPatch(st);
    float slopeLower = p.depths.y - p.depths.x, slopeUpper = p.depths.w - p.depths.z;
    float lower = p.depths.x + slopeLower * p.weight.x;
    float upper = p.depths.z + slopeUpper * p.weight.x;
    return vec2(slopeLower + (slopeUpper - slopeLower) * p.weight.y, upper - lower) *
           vec2(textureSize(uHeightMap, 0));
}

// --- access by cells, for searches that traverse the map's bilinear patches ----------------------
// Texel coordinates are st times the size minus 1/2, so that integers are texel centers. Cell (i, j) is the
// square between the centers of texels (i, j) and (i+1, j+1), in which the exact depth is bilinear.

// Along s, t: 1 if the map clamps, 0 if it repeats.
ivec2 reliefMapClamps() { return uHeightMapClamps; }

// Wraps any integer. In GLSL, % is undefined for negative operands.
int wrapAnyTexel(int i, int size, int clamps) {
    if (clamps != 0) return clamp(i, 0, size - 1);
    return i >= 0 ? i % size : size - 1 - (-1 - i) % size;
}

// Depths of texels (i, j), (i+1, j), (i, j+1), (i+1, j+1) for any integers i, j, whatever the filter. Counts
// as one lookup, because a bilinear lookup reads the same four texels.
vec4 reliefCell(ivec2 cell) {
    ++gHeightLookups;
    ivec2 size = reliefMapSize();
    int i0 = wrapAnyTexel(cell.x, size.x, uHeightMapClamps.x), i1 = wrapAnyTexel(cell.x + 1, size.x, uHeightMapClamps.x);
    int j0 = wrapAnyTexel(cell.y, size.y, uHeightMapClamps.y), j1 = wrapAnyTexel(cell.y + 1, size.y, uHeightMapClamps.y);
    return vec4(texelFetch(uHeightMap, ivec2(i0, j0), 0).r, texelFetch(uHeightMap, ivec2(i1, j0), 0).r,
                texelFetch(uHeightMap, ivec2(i0, j1), 0).r, texelFetch(uHeightMap, ivec2(i1, j1), 0).r);
}
