// The first hit of the ray with the exact bilinear relief, the ground truth for searches on the same base.
// The cells along the ray are visited in order, and the quadratic equation of each is solved
// (shaders/relief_walk.glsl).

ReliefHit traceRelief(ReliefRay ray) {
    ReliefWalk walk = beginWalk(ray);
    ivec2 cell = ivec2(0);
    float t = 0.0;
    vec2 corner = walk.start; // entry of the ray into the cell, relative to its lower left corner
    for (int i = 0; i < most_cells; ++i) {
        countIteration();
        vec2 leaves = leavesCells(walk, cell, cell);
        bool alongS = leaves.x <= leaves.y;
        float next = max(min(min(leaves.x, leaves.y), 1.0), t);
        float root = hitInCell(ray, walk, cell, corner, t, next);
        if (root <= 1.0) return hitAt(ray, root);
        if (next >= 1.0) {
            if (ray.endDepth >= 1.0) return hitAt(ray, 1.0); // depth 1 is inside, whatever the rounding
            return missed();
        }
        cell += alongS ? ivec2(walk.travel.x > 0.0 ? 1 : -1, 0) : ivec2(0, walk.travel.y > 0.0 ? 1 : -1);
        t = next;
        corner = walk.start - vec2(cell) + walk.travel * t;
        if (alongS) // exactly on the border, so that both cells have the same depth there
            corner.x = walk.travel.x > 0.0 ? 0.0 : 1.0;
        else
            corner.y = walk.travel.y > 0.0 ? 0.0 : 1.0;
    }
    return hitAt(ray, t); // reached most_cells
}
