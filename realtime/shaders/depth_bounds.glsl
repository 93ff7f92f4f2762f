// Least and most depth over blocks of cells: level k has blocks of 2^k x 2^k cells, the last one of an odd row also its left-over
// (inputs/README.md, kind max_mipmap).

uniform sampler2DArray uDepthBounds; // r: least depth, g: most

int depthBoundsLevels() {
    ivec2 size = reliefMapSize();
    int levels = 1;
    for (int side = max(size.x, size.y); side > 1; side /= 2) ++levels;
    return levels;
}

// The block of `level` that holds a cell, which must be inside of the map.
ivec2 blockOf(ivec2 cell, int level) {
    return min(ivec2(cell.x >> level, cell.y >> level), textureSize(uDepthBounds, level).xy - 1);
}

// (least, most) depth of a block.
vec2 depthBounds(ivec2 block, int level) {
    ++gBakedLookups;
    return texelFetch(uDepthBounds, ivec3(block, 0), level).rg;
}
