// Depth below a quadric as the distance to its nearest point: D_n. With `texture_from = foot` the map is also
// read at that point, and the relief is exactly the quadric displaced along its normals.
//
// In the principal frame, with orthogonal x and y along the directions of the principal curvatures and z
// inward, the base is z = k1 x^2 + k2 y^2. The foot point (w, k . w^2) of a point (p, z) satisfies p - w = -2
// l k w and z - k . w^2 = l for a number l, the component of the distance along z:
//     w = p / (1 - 2 l k),   F(l) = z - k . w^2 - l = 0,   F'(l) = -1 - 4 sum k^2 w^2 / (1 - 2 l k),
//     distance = l sqrt(1 + 4 sum k^2 w^2),
// positive inside. F decreases monotonically while 1 - 2 l k > 0, so it has one root there. Newton's method
// starts at l = 0, the point itself. After three steps the error is at most 1e-7 of the depth for a relief as
// deep as 1/4 of the smallest radius of curvature, and 5e-5 for 1/2; after two steps 9e-4 and 0.012 (measured
// at 200 000 points of random rays; starting at l = D_z, three steps leave 0.009 and 0.4).
//
// surfaceA: k1, k2 and the ray's direction along x, y (ray.cosine along z); surfaceB: (s, t) per unit of x,
// then of y.

// Minimum of 1 - 2 l k: beyond the centers of curvature (a relief deeper than the radius) the nearest point
// isn't unique.
const float kMinFocal = 1e-3;
// Tolerance of the end of the search, relative to the relief depth: 1/16 of the final interval of 10 linear
// steps and 6 bisections.
const float kEndTolerance = 1e-4;
// Each Newton step squares the error; for a ray tangent to depth 1, which has a double root, it only quarters
// it.
const int kEndSteps = 8;
const float kFurthest = 4.0;
// The largest depth that counts as less than 1.
const float kShort = 1.0 - kEndTolerance;

// Foot point and signed distance, world units, of a point in the principal frame.
vec3 nearestOf(vec2 k, vec3 point) {
    float along = 0.0;
    vec2 focal, foot;
    for (int i = 0; i < newton_steps; ++i) {
        focal = max(1.0 - 2.0 * along * k, kMinFocal);
        foot = point.xy / focal;
        float miss = point.z - dot(k, foot * foot) - along;
        along += miss / (1.0 + 4.0 * dot(k * foot, k * foot / focal));
    }
    foot = point.xy / max(1.0 - 2.0 * along * k, kMinFocal);
    vec2 slope = 2.0 * k * foot;
    return vec3(foot, along * sqrt(1.0 + dot(slope, slope)));
}

// Derivative of the distance along `way`: its component along the inward normal at the foot point.
float fallOf(vec2 k, vec2 foot, vec3 way) {
    vec2 slope = 2.0 * k * foot;
    return (way.z - dot(slope, way.xy)) / sqrt(1.0 + dot(slope, slope));
}

// End of the search in world units, and the depth there. D_n <= D_z, and both are 0 on the quadric, so if D_z
// turns back before 1, so does D_n. Otherwise Newton's method starts where D_z = 1. For a convex base, the
// distance along a ray is concave, so the iteration approaches the first root from the left, or there is no
// root before the ray returns to the quadric at tau = c / f, where the search then ends. A concave base lies
// above its tangent plane, so D_n >= tau c bounds the end. Along a saddle, D_n may reach 1 or return to 0 far
// outside the region in which the quadric was fitted, or never. So roots beyond kFurthest times the end of
// D_z are ignored, and the search ends at the end of D_z with a depth below 1.
vec2 nearestEnd(vec2 k, vec3 direction, float depthWorld) {
    float f = dot(k, direction.xy * direction.xy);
    vec2 end = searchEnd(direction.z / depthWorld, f / depthWorld);
    if (end.y < 1.0) return end;
    float furthest = k.x <= 0.0 ? depthWorld / direction.z : kFurthest * end.x;
    float tau = end.x;
    for (int i = 0; i < kEndSteps && tau * f < direction.z; ++i) {
        vec3 nearest = nearestOf(k, direction * tau);
        float fall = fallOf(k, nearest.xy, direction), gap = depthWorld - nearest.z;
        if (!(fall > 0.0)) break;
        tau = min(tau + gap / fall, furthest);
        if (abs(gap) <= kEndTolerance * depthWorld) return vec2(tau, 1.0);
    }
    if (f > 0.0 && (k.y >= 0.0 || direction.z <= furthest * f)) return vec2(direction.z / f, 0.0);
    return vec2(end.x, min(nearestOf(k, direction * end.x).z / depthWorld, kShort));
}

// Columns: (s, t) along the first and the second principal direction, per world unit; `curvatures` k1 >= k2.
vec4 principalFrame(ReliefFrame frame, vec2 scale, out vec2 curvatures) {
    float cosine = dot(frame.positionS, frame.positionT) / max(scale.x * scale.y, 1e-30);
    float sine = sqrt(max(1.0 - cosine * cosine, kSmallestSineSquared));
    // Orthogonal coordinates with e1 = the tangent of s, in which the oblique y axis is (cosine, sine). x = X
    // - cosine / sine Y, y = Y / sine.
    float shear = -cosine / sine;
    vec3 form = frame.curvature; // A x^2 + B y^2 + C x y to first X^2 + mixed X Y + second Y^2
    float first = form.x, mixed = 2.0 * form.x * shear + form.z / sine;
    float second = (form.x * shear + form.z / sine) * shear + form.y / (sine * sine);
    float mean = 0.5 * (first + second), difference = 0.5 * (first - second);
    float radius = length(vec2(difference, 0.5 * mixed));
    curvatures = mean + vec2(radius, -radius);
    vec2 along = vec2(1.0, 0.0); // half the angle of (difference, mixed / 2), without cancellation
    if (radius > 0.0) {
        float half0 = sqrt(0.5 + 0.5 * abs(difference) / radius), half1 = 0.25 * mixed / (radius * half0);
        along = difference >= 0.0 ? vec2(half0, half1) : vec2(half1, half0);
    }
    vec2 across = vec2(-along.y, along.x), perUnit = 1.0 / max(scale, 1e-30);
    return vec4(vec2(along.x + shear * along.y, along.y / sine) * perUnit,
                vec2(across.x + shear * across.y, across.y / sine) * perUnit);
}

bool enterRelief(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray) {
    vec2 scale = reliefScale(frame), k;
    vec4 stPer = principalFrame(frame, scale, k);
    float cosine = direction.z * frame.depthWorld, determinant = stPer.x * stPer.w - stPer.z * stPer.y;
    vec2 way = direction.xy == vec2(0.0) ? vec2(0.0) // a pole: 0 / 0
                                         : vec2(stPer.w * direction.x - stPer.z * direction.y,
                                                stPer.x * direction.y - stPer.y * direction.x) / determinant;
    vec2 end = cosine > kGrazingCosine ? nearestEnd(k, vec3(way, cosine), frame.depthWorld) : vec2(0.0);
    ray = ReliefRay(st, vec2(0.0), end.y, 0.0, end.x, cosine, scale, frame.depthWorld, vec4(k, way), stPer);
    ray.stTravel = surfacePosition(ray, 1.0).xy - st;
    return cosine > kGrazingCosine;
}

vec3 nearestAt(ReliefRay ray, float t) {
    return nearestOf(ray.surfaceA.xy, vec3(ray.surfaceA.zw, ray.cosine) * (ray.lengthWorld * t));
}

vec2 stAlong(ReliefRay ray, vec2 principal) { return ray.surfaceB.xy * principal.x + ray.surfaceB.zw * principal.y; }

// d is exactly endDepth at t = 1.
vec3 surfacePosition(ReliefRay ray, float t) {
    vec3 nearest = nearestAt(ray, t);
    vec2 principal = texture_from == texture_from_foot ? nearest.xy : ray.surfaceA.zw * (ray.lengthWorld * t);
    return vec3(ray.st + stAlong(ray, principal), t >= 1.0 ? ray.endDepth : nearest.z / ray.depthWorld);
}

float surfaceDescent(ReliefRay ray, float t) {
    float fall = fallOf(ray.surfaceA.xy, nearestAt(ray, t).xy, vec3(ray.surfaceA.zw, ray.cosine));
    return fall * ray.lengthWorld / ray.depthWorld;
}

// The frame of the base at the foot point, displaced inward by the depth: n varies along the surface, so P_s
// = S_s - depth n_s (Weingarten's equations, with the first and second fundamental forms along the unit
// tangents of s and t).
ReliefFrame frameAt(ReliefFrame frame, ReliefRay ray, float t) {
    vec3 nearest = nearestAt(ray, t);
    vec2 scale = max(reliefScale(frame), 1e-30);
    ReliefFrame foot = tiltedFrame(frame, stAlong(ray, nearest.xy));
    vec3 alongS = foot.positionS / scale.x, alongT = foot.positionT / scale.y;
    vec3 across = cross(alongS, alongT);
    if (!(dot(across, across) > kSmallestSineSquared)) return foot;
    foot.normal = normalize(dot(across, frame.normal) < 0.0 ? -across : across);
    float lean = dot(foot.normal, frame.normal);
    mat2 firstForm = mat2(dot(alongS, alongS), dot(alongS, alongT), dot(alongS, alongT), dot(alongT, alongT));
    mat2 secondForm = -lean * mat2(2.0 * frame.curvature.x, frame.curvature.z, frame.curvature.z, 2.0 * frame.curvature.y);
    mat2 shape = inverse(firstForm) * secondForm; // columns: coefficients of -n_s and -n_t in S_s, S_t
    foot.positionS += scale.x * nearest.z * (alongS * shape[0].x + alongT * shape[0].y);
    foot.positionT += scale.y * nearest.z * (alongS * shape[1].x + alongT * shape[1].y);
    return foot;
}
