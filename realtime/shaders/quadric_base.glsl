// Functions shared by the surfaces with a quadric base, z = -(A x^2 + C x y + B y^2) in the fragment's frame.
// z points outward; x and y are in world units along the unit tangents, which need not be orthogonal.

// Distance of the base below the tangent plane at (x, y).
float quadricFall(vec3 curvature, vec2 xy) {
    return dot(curvature, vec3(xy * xy, xy.x * xy.y));
}

// Its derivatives with respect to x and y.
vec2 quadricGradient(vec3 curvature, vec2 xy) {
    return 2.0 * curvature.xy * xy + curvature.z * xy.yx;
}

// The frame of the base at the offset `stTraveled` from the fragment; depth is measured along the fragment's
// normal.
ReliefFrame tiltedFrame(ReliefFrame frame, vec2 stTraveled) {
    vec2 scale = reliefScale(frame);
    vec2 fall = quadricGradient(frame.curvature, scale * stTraveled) * scale; // per unit of s and t
    frame.positionS -= frame.normal * fall.x;
    frame.positionT -= frame.normal * fall.y;
    return frame;
}

// --- D_z: depth along the fragment's normal (Oliveira, Policarpo, RP-351, Eq. 7) --------------------------
// d(tau) = v_d tau - f tau^2 with f = alpha v_s^2 + gamma v_s v_t + beta v_t^2, alpha = A sx^2 / sz, beta = B
// sy^2 / sz (the mapping scale squared: listing 5.7 of Watt and Policarpo 2005, chapter 5, lacks it), gamma =
// C sx sy / sz. If the ray leaves the layer without a hit, the fragment is outside the silhouette and is
// discarded.

// End of the search interval in world units and the depth there: the first point with d = 1, at tau = 2 /
// (v_d + sqrt(v_d^2 - 4 f)), or else the return to d = 0, at tau = v_d / f. This form is stable for every f
// including 0, whereas the textbook root (v_d - sqrt(v_d^2 - 4 f)) / (2 f) cancels for small f.
vec2 searchEnd(float descent, float f) {
    float discriminant = descent * descent - 4.0 * f;
    if (discriminant >= 0.0) return vec2(2.0 / (descent + sqrt(discriminant)), 1.0);
    return vec2(descent / f, 0.0);
}

bool enterVertical(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray) {
    vec2 scale = reliefScale(frame);
    float f = quadricFall(frame.curvature, direction.xy * scale) / frame.depthWorld;
    bool descends = direction.z * frame.depthWorld > kGrazingCosine;
    vec2 end = descends ? searchEnd(direction.z, f) : vec2(0.0);
    ray = ReliefRay(st, direction.xy * end.x, end.y, f * end.x * end.x, end.x, direction.z * frame.depthWorld, scale,
                    frame.depthWorld, vec4(0.0), vec4(0.0));
    return descends;
}

// Written so that d is exactly endDepth at t = 1; otherwise rounding could miss a floor at depth 1.
vec3 verticalPosition(ReliefRay ray, float t) {
    return vec3(ray.st + ray.stTravel * t, t * ray.endDepth + ray.bend * t * (1.0 - t));
}

float verticalDescent(ReliefRay ray, float t) { return ray.endDepth + ray.bend * (1.0 - 2.0 * t); }

// d' is linear in t and has its maximum at one of the ends.
float verticalSteepest(ReliefRay ray, float t) {
    return max(max(verticalDescent(ray, t), verticalDescent(ray, 1.0)), 0.0);
}
