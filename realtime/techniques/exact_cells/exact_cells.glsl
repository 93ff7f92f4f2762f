// The first hit of the ray with the exact bilinear relief: the yardstick of a perfect search on the same base.
//
// Between texel centres the depth D is a bilinear patch and the ray's st is linear in t, so D along the ray is a quadratic in t, as
// is d(t). The ray's cells are visited in order and each quadratic D - d solved for its first root: no step can be too long.
//
// All positions are texels relative to the cell the ray starts in, and every crossing of a border is computed from the border's
// number: nothing adds up, and coordinates far from 0 lose no digits.

// A crossing that isn't on the ray.
const float kNeverCrossed = 2.0;

// t at which the ray leaves cell `cell` along one axis; `start` texels into cell 0, `travel` texels from t = 0 to 1. `low` and
// `high` are the cells that go on for ever because the map is clamped there, if it is.
float crossing(int cell, float start, float travel, int low, int high, bool clamps) {
    if (clamps && (travel > 0.0 ? cell >= high : cell <= low)) return kNeverCrossed;
    float way = travel > 0.0 ? float(cell + 1) - start : start - float(cell);
    return way < abs(travel) ? max(way, 0.0) / abs(travel) : kNeverCrossed;
}

// First root x > 0 of gap + slope x + bend x^2 with gap > 0, kNeverCrossed if there is none. Every branch adds numbers of one
// sign. A root that rounding puts beyond the cell is found by the next one, whose gap begins at or below 0.
float firstRoot(float gap, float slope, float bend) {
    float discriminant = slope * slope - 4.0 * bend * gap;
    float root = kNeverCrossed;
    if (discriminant >= 0.0) {
        if (slope < 0.0)
            root = 2.0 * gap / (sqrt(discriminant) - slope);
        else if (bend < 0.0)
            root = (slope + sqrt(discriminant)) / (-2.0 * bend);
    }
    return root;
}

// Texel coordinate of `s` (conventions: height_map.glsl): its whole part, and the rest. s size has more digits than a float:
// s is cut in two so that the product of its first part, a multiple of 1/1024, is exact up to sizes of 16384.
vec2 texelOf(float s, float size, bool clamps) {
    float unit = clamps ? s : s - floor(s);
    float first = floor(unit * 1024.0) / 1024.0;
    float texels = first * size, whole = floor(texels);
    float rest = (texels - whole) + ((unit - first) * size - 0.5);
    return vec2(whole + floor(rest), rest - floor(rest));
}

ReliefHit traceRelief(ReliefRay ray) {
    ivec2 size = reliefMapSize();
    bool clampsS = reliefMapClamps().x != 0, clampsT = reliefMapClamps().y != 0;
    vec2 travel = ray.stTravel * vec2(size);
    vec2 texelS = texelOf(ray.st.x, float(size.x), clampsS), texelT = texelOf(ray.st.y, float(size.y), clampsT);
    vec2 whole = vec2(texelS.x, texelT.x);
    // The cell the ray starts in; beyond a clamped border the outermost cells go on for ever.
    ivec2 firstCell = ivec2(clamp(whole, vec2(-1.0), vec2(size - 1)));
    vec2 start = vec2(texelS.y, texelT.y) + (whole - vec2(firstCell));
    ivec2 low = ivec2(-1) - firstCell, high = size - 1 - firstCell; // relative, as `cell`

    ivec2 cell = ivec2(0);
    float t = 0.0;
    vec2 corner = start; // where the ray enters the cell, from its lower left corner
    for (int i = 0; i < most_cells; ++i) {
        countIteration();
        float leavesS = crossing(cell.x, start.x, travel.x, low.x, high.x, clampsS);
        float leavesT = crossing(cell.y, start.y, travel.y, low.y, high.y, clampsT);
        bool alongS = leavesS <= leavesT;
        float next = max(min(min(leavesS, leavesT), 1.0), t);
        float way = next - t;

        vec4 depths = reliefCell(firstCell + cell);
        float slopeS = depths.y - depths.x, slopeT = depths.z - depths.x;
        float twist = (depths.w - depths.z) - slopeS;
        vec2 across = travel * way; // texels, through the cell
        float gap = depths.x + slopeS * corner.x + slopeT * corner.y + twist * corner.x * corner.y -
                    reliefPosition(ray, t).z;
        if (gap <= 0.0) return hitAt(ray, t); // on the relief or in it already
        float slope = slopeS * across.x + slopeT * across.y + twist * (corner.x * across.y + corner.y * across.x) -
                      way * (ray.endDepth + ray.bend * (1.0 - 2.0 * t));
        float root = firstRoot(gap, slope, twist * across.x * across.y + ray.bend * way * way);
        if (root <= 1.0) return hitAt(ray, t + root * way);
        if (next >= 1.0) {
            if (ray.endDepth >= 1.0) return hitAt(ray, 1.0); // depth 1 is inside whatever rounding says
            return missed();
        }

        ivec2 stepped = alongS ? ivec2(travel.x > 0.0 ? 1 : -1, 0) : ivec2(0, travel.y > 0.0 ? 1 : -1);
        cell += stepped;
        t = next;
        corner = start - vec2(cell) + travel * t;
        if (alongS) // on the border exactly, so that both its sides see the same depth
            corner.x = travel.x > 0.0 ? 0.0 : 1.0;
        else
            corner.y = travel.y > 0.0 ? 0.0 : 1.0;
    }
    return hitAt(ray, t); // most_cells ran out
}
