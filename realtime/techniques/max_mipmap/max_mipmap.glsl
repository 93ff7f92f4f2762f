// Quadtree traversal (Tevs, Ihrke, Seidel 2008): a block of cells is skipped in one step if the ray stays
// above its minimum depth. Otherwise the traversal descends to the next finer level, down to single cells,
// whose patch is intersected exactly (shaders/relief_walk.glsl).

// Maximum depth of the ray between t and `next`.
float deepest(ReliefRay ray, float t, float next) {
    float depth = max(reliefPosition(ray, t).z, reliefPosition(ray, next).z);
    float top = 0.5 + 0.5 * ray.endDepth / max(ray.bend, 1e-30); // the maximum of d(t) over a convex base
    if (ray.bend > 0.0 && top > t && top < next) depth = max(depth, reliefPosition(ray, top).z);
    return depth;
}

// First and last cell of a block along one axis, relative to the walk's first cell; `wrapped` is the cell's
// index in the map, `block` the block's.
ivec2 blockCells(int cell, int wrapped, int block, int level, int blocks, int size, int low, int high, bool clamps) {
    if (clamps && (cell <= low || cell >= high)) return ivec2(cell); // extends to infinity
    int lowest = cell - (wrapped - (block << level));
    int highest = cell + ((block == blocks - 1 ? size : (block + 1) << level) - 1 - wrapped);
    return ivec2(lowest, highest);
}

ReliefHit traceRelief(ReliefRay ray) {
    ReliefWalk walk = beginWalk(ray);
    ivec2 size = reliefMapSize();
    int topLevel = depthBoundsLevels() - 1, level = topLevel;
    ivec2 cell = ivec2(0);
    float t = 0.0;
    for (int i = 0; i < most_steps; ++i) {
        countIteration();
        ivec2 at = walk.firstCell + cell;
        ivec2 wrapped = ivec2(wrapAnyTexel(at.x, size.x, walk.clamps.x), wrapAnyTexel(at.y, size.y, walk.clamps.y));
        ivec2 block = blockOf(wrapped, level);
        ivec2 blocks = depthBoundsSize(level);
        ivec2 cellsS = blockCells(cell.x, wrapped.x, block.x, level, blocks.x, size.x, walk.low.x, walk.high.x, walk.clamps.x != 0);
        ivec2 cellsT = blockCells(cell.y, wrapped.y, block.y, level, blocks.y, size.y, walk.low.y, walk.high.y, walk.clamps.y != 0);
        vec2 leaves = leavesCells(walk, ivec2(cellsS.x, cellsT.x), ivec2(cellsS.y, cellsT.y));
        bool alongS = leaves.x <= leaves.y;
        float next = max(min(min(leaves.x, leaves.y), 1.0), t);
        if (deepest(ray, t, next) >= depthBounds(block, level).x) {
            if (level > 0) {
                --level;
                continue;
            }
            vec2 corner = clamp(walk.start - vec2(cell) + walk.travel * t, vec2(0.0), vec2(1.0));
            float root = hitInCell(ray, walk, cell, corner, t, next);
            if (root <= 1.0) return hitAt(ray, root);
        }
        if (next >= 1.0) {
            if (ray.endDepth >= 1.0) return hitAt(ray, 1.0);
            return missed();
        }
        t = next;
        cell = ivec2(clamp(floor(walk.start + walk.travel * t), vec2(cellsS.x, cellsT.x), vec2(cellsS.y, cellsT.y)));
        if (alongS)
            cell.x = walk.travel.x > 0.0 ? cellsS.y + 1 : cellsS.x - 1;
        else
            cell.y = walk.travel.y > 0.0 ? cellsT.y + 1 : cellsT.x - 1;
        level = min(level + 1, topLevel);
    }
    return hitAt(ray, t); // reached most_steps
}
