uniform sampler2DArray uThrowawayMap;

float throwawayDepth(vec2 st) {
    ++gBakedLookups;
    return texelFetch(uThrowawayMap, ivec3(texelCorners(st).low, 0), 0).r;
}
