// The ray's way through the cells of the map, for searches that follow its bilinear patches.
//
// Between texel centers the depth D is a bilinear patch and the ray's st is linear in t, so D along the ray is a quadratic in t, as
// is d(t): the first root of D - d in a cell is the first hit there, no step can be too long.
//
// All positions are texels relative to the cell the ray starts in, and every crossing of a border is computed from the border's
// number: nothing adds up, and coordinates far from 0 lose no digits.

// A crossing or a root that isn't on the ray.
const float kNever = 2.0;

struct ReliefWalk {
    ivec2 firstCell;  // the cell the ray starts in; beyond a clamped border the outermost cells go on for ever
    vec2 start;       // texels into it
    vec2 travel;      // texels from t = 0 to 1
    ivec2 low, high;  // cells, relative, that go on for ever where the map is clamped
    ivec2 clamps;     // 1: it is, along s, t
};

// Texel coordinate of `s` (conventions: height_map.glsl): its whole part, and the rest. s size has more digits than a float:
// s is cut in two so that the product of its first part, a multiple of 1/1024, is exact up to sizes of 16384.
vec2 texelOf(float s, float size, bool clamps) {
    float unit = clamps ? s : s - floor(s);
    float first = floor(unit * 1024.0) / 1024.0;
    float texels = first * size, whole = floor(texels);
    float rest = (texels - whole) + ((unit - first) * size - 0.5);
    return vec2(whole + floor(rest), rest - floor(rest));
}

ReliefWalk beginWalk(ReliefRay ray) {
    ReliefWalk walk;
    ivec2 size = reliefMapSize();
    walk.clamps = reliefMapClamps();
    vec2 texelS = texelOf(ray.st.x, float(size.x), walk.clamps.x != 0);
    vec2 texelT = texelOf(ray.st.y, float(size.y), walk.clamps.y != 0);
    vec2 whole = vec2(texelS.x, texelT.x);
    walk.firstCell = ivec2(clamp(whole, vec2(-1.0), vec2(size - 1)));
    walk.start = vec2(texelS.y, texelT.y) + (whole - vec2(walk.firstCell));
    walk.travel = ray.stTravel * vec2(size);
    walk.low = ivec2(-1) - walk.firstCell;
    walk.high = size - 1 - walk.firstCell;
    return walk;
}

// Along one axis: `start` texels into the first cell, `travel` texels from t = 0 to 1, `low` and `high` the cells that go on for ever.
float crossing(int lowest, int highest, float start, float travel, int low, int high, bool clamps) {
    if (clamps && (travel > 0.0 ? highest >= high : lowest <= low)) return kNever;
    float way = travel > 0.0 ? float(highest + 1) - start : start - float(lowest);
    return way < abs(travel) ? max(way, 0.0) / abs(travel) : kNever;
}

// t at which the ray leaves the cells lowest to highest (relative) along s and along t, kNever if not before t = 1.
vec2 leavesCells(ReliefWalk walk, ivec2 lowest, ivec2 highest) {
    return vec2(crossing(lowest.x, highest.x, walk.start.x, walk.travel.x, walk.low.x, walk.high.x, walk.clamps.x != 0),
                crossing(lowest.y, highest.y, walk.start.y, walk.travel.y, walk.low.y, walk.high.y, walk.clamps.y != 0));
}

// First root x > 0 of gap + slope x + bend x^2 with gap > 0, kNever if there is none. Every branch adds numbers of one
// sign. A root that rounding puts beyond the cell is found by the next one, whose gap begins at or below 0.
float firstRoot(float gap, float slope, float bend) {
    float discriminant = slope * slope - 4.0 * bend * gap;
    float root = kNever;
    if (discriminant >= 0.0) {
        if (slope < 0.0)
            root = 2.0 * gap / (sqrt(discriminant) - slope);
        else if (bend < 0.0)
            root = (slope + sqrt(discriminant)) / (-2.0 * bend);
    }
    return root;
}

// t of the first hit between t and `next` on the patch of one cell, kNever if none; `corner`: texels from the cell's lower
// left corner to the ray at t. One counted look-up.
float hitInCell(ReliefRay ray, ReliefWalk walk, ivec2 cell, vec2 corner, float t, float next) {
    vec4 depths = reliefCell(walk.firstCell + cell);
    float slopeS = depths.y - depths.x, slopeT = depths.z - depths.x;
    float twist = (depths.w - depths.z) - slopeS;
    float way = next - t;
    vec2 across = walk.travel * way; // texels, through the cell
    float gap = depths.x + slopeS * corner.x + slopeT * corner.y + twist * corner.x * corner.y - reliefPosition(ray, t).z;
    if (gap <= 0.0) return t; // on the relief or in it already
    float slope = slopeS * across.x + slopeT * across.y + twist * (corner.x * across.y + corner.y * across.x) -
                  way * (ray.endDepth + ray.bend * (1.0 - 2.0 * t));
    float root = firstRoot(gap, slope, twist * across.x * across.y + ray.bend * way * way);
    return root <= 1.0 ? t + root * way : kNever;
}
