// Traversal of the map's cells along the ray, for searches that intersect the bilinear patches.
//
// Between texel centers the depth D is a bilinear patch and the ray's st is linear in t, so D along the ray
// is quadratic in t, as is d(t). The first root of D - d in a cell is the first hit there, so the search is
// exact.
//
// Positions are in texels relative to the cell in which the ray starts, and every crossing of a cell border
// is computed from the border's index. So rounding errors don't accumulate, and coordinates far from 0 lose
// no precision.

// Value of t for a crossing or root that isn't on the ray.
const float kNever = 2.0;

struct ReliefWalk {
    // The cell in which the ray starts; the outermost cells of a clamped map extend to infinity.
    ivec2 firstCell;
    vec2 start;       // position in that cell, texels
    vec2 travel;      // displacement from t = 0 to 1, texels
    ivec2 low, high;  // the outermost cells, relative, which extend to infinity if the map clamps
    ivec2 clamps;     // along s, t: 1 if the map clamps
};

// Texel coordinate of `s` (conventions: height_map.glsl): its integer part and its fraction. The product of s
// and the size would need more digits than a float has. So s is split in two, and the product of its first
// part, a multiple of 1/1024, is exact for sizes up to 16384.
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

// leavesCells along one axis; the parameters are components of ReliefWalk.
float crossing(int lowest, int highest, float start, float travel, int low, int high, bool clamps) {
    if (clamps && (travel > 0.0 ? highest >= high : lowest <= low)) return kNever;
    float way = travel > 0.0 ? float(highest + 1) - start : start - float(lowest);
    return way < abs(travel) ? max(way, 0.0) / abs(travel) : kNever;
}

// t at which the ray leaves the cells from lowest to highest (relative) along s and along t; kNever if it
// doesn't before t = 1.
vec2 leavesCells(ReliefWalk walk, ivec2 lowest, ivec2 highest) {
    return vec2(crossing(lowest.x, highest.x, walk.start.x, walk.travel.x, walk.low.x, walk.high.x, walk.clamps.x != 0),
                crossing(lowest.y, highest.y, walk.start.y, walk.travel.y, walk.low.y, walk.high.y, walk.clamps.y != 0));
}

// First root x > 0 of gap + slope x + bend x^2 with gap > 0, kNever if there is none. No branch cancels,
// because each adds numbers of equal sign. If rounding moves a root beyond the cell, the next cell finds it,
// because its gap is then <= 0 at the start.
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

// t of the first hit between t and `next` with the patch of one cell; kNever if there is none. `corner`:
// texels from the cell's lower left corner to the ray at t. Counts one lookup.
float hitInCell(ReliefRay ray, ReliefWalk walk, ivec2 cell, vec2 corner, float t, float next) {
    vec4 depths = reliefCell(walk.firstCell + cell);
    float slopeS = depths.y - depths.x, slopeT = depths.z - depths.x;
    float twist = (depths.w - depths.z) - slopeS;
    float way = next - t;
    vec2 across = walk.travel * way; // texels, through the cell
    float gap = depths.x + slopeS * corner.x + slopeT * corner.y + twist * corner.x * corner.y - reliefPosition(ray, t).z;
    if (gap <= 0.0) return t; // already on or inside the relief
    float slope = slopeS * across.x + slopeT * across.y + twist * (corner.x * across.y + corner.y * across.x) -
                  way * (ray.endDepth + ray.bend * (1.0 - 2.0 * t));
    float root = firstRoot(gap, slope, twist * across.x * across.y + ray.bend * way * way);
    return root <= 1.0 ? t + root * way : kNever;
}
