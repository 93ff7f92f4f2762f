// The base is a quadric z = -(A x^2 + B y^2) in the frame of the fragment, fitted at the vertices (Oliveira, Policarpo,
// RP-351, section 3): depth below it along the normal is d(tau) = v_d tau - f tau^2, with
//     f = alpha v_s^2 + beta v_t^2,   alpha = A sx^2 / sz,   beta = B sy^2 / sz       (the mapping scale squared: L5.7
//                                                                                    of the original lacks it)
// Where the ray leaves the layer without a hit the fragment lies outside of the outline and is discarded.

// End of the search interval in world units, and the depth there: the first of d = 1, at
// tau = 2 / (v_d + sqrt(v_d^2 - 4 f)), and the return to d = 0, at tau = v_d / f. The form is stable for every f through
// 0; the textbook root (v_d - sqrt(v_d^2 - 4 f)) / (2 f) cancels for small f.
vec2 searchEnd(float descent, float f) {
    float discriminant = descent * descent - 4.0 * f;
    if (discriminant >= 0.0) return vec2(2.0 / (descent + sqrt(discriminant)), 1.0);
    return vec2(descent / f, 0.0);
}

bool enterRelief(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray) {
    vec2 scale = reliefScale(frame);
    vec2 bend = frame.curvature.xy * scale * scale / frame.depthWorld;
    float f = dot(bend, direction.xy * direction.xy);
    bool descends = direction.z * frame.depthWorld > kGrazingCosine;
    vec2 end = descends ? searchEnd(direction.z, f) : vec2(0.0);
    ray = ReliefRay(st, direction.xy * end.x, end.y, f * end.x * end.x, end.x, direction.z * frame.depthWorld, scale,
                    frame.depthWorld);
    return descends;
}

// Written so that d is exactly endDepth at t = 1: a floor at depth 1 isn't missed by rounding.
vec3 reliefPosition(ReliefRay ray, float t) {
    return vec3(ray.st + ray.stTravel * t, t * ray.endDepth + ray.bend * t * (1.0 - t));
}

// d' = endDepth + bend (1 - 2 t) is linear in t: largest at one of the ends.
float steepestDescent(ReliefRay ray, float t) {
    return max(max(ray.endDepth + ray.bend * (1.0 - 2.0 * t), ray.endDepth - ray.bend), 0.0);
}

// dz/ds of the quadric, x = sx s: the frame of the hit isn't that of the fragment.
vec2 baseSlope(ReliefFrame frame, vec2 stTravelled) {
    vec2 scaleSquared = vec2(dot(frame.positionS, frame.positionS), dot(frame.positionT, frame.positionT));
    return -2.0 * frame.curvature.xy * scaleSquared * stTravelled;
}
