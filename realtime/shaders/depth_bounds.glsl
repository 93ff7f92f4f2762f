// Minimum and maximum depth over blocks of cells. Level k has blocks of 2^k x 2^k cells; if a row's length is
// odd, its last block includes the remaining cell (realtime/bake/README.md, kind max_mipmap).
//
// All levels are packed into one image, level 0 on the left and the others stacked to its right
// (baked_input.cpp), because llvmpipe reads the same mip level for all four pixels of a quad, even with an
// explicit level.

uniform sampler2DArray uDepthBounds; // r: minimum depth, g: maximum depth

int depthBoundsLevels() {
    ivec2 size = reliefMapSize();
    int levels = 1;
    for (int side = max(size.x, size.y); side > 1; side /= 2) ++levels;
    return levels;
}

// Number of blocks of a level along s and t.
ivec2 depthBoundsSize(int level) {
    ivec2 size = reliefMapSize();
    return max(ivec2(size.x >> level, size.y >> level), ivec2(1));
}

// The block of `level` that contains a cell, which must be inside the map.
ivec2 blockOf(ivec2 cell, int level) { return min(ivec2(cell.x >> level, cell.y >> level), depthBoundsSize(level) - 1); }

// (minimum, maximum) depth of a block.
vec2 depthBounds(ivec2 block, int level) {
    ++gBakedLookups;
    ivec2 size = reliefMapSize();
    ivec2 corner = level == 0 ? ivec2(0) : ivec2(size.x, size.y - (size.y >> (level - 1)) + level - 1);
    return texelFetch(uDepthBounds, ivec3(corner + block, 0), 0).rg;
}
