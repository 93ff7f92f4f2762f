// Depth below a quadric, perpendicular to the ray: D_U (Oliveira, Policarpo, RP-351, Eqs 3 to 6).
//
// U is the normalized component of the outward normal N orthogonal to the ray V; it lies in the plane of N
// and V. In that plane, with x along the ray's projection to the tangent plane and z inward, the quadric is z
// = k x^2 with its curvature k in that direction, and
//     V = (s, c),  U = (c, -s),  with s and c the sine and cosine of the angle between ray and inward normal.
// From P = tau V the distance sigma along U to the quadric solves A sigma^2 + B sigma + C = 0 with
//     A = k c^2,  B = 2 k tau s c + s,  C = k tau^2 s^2 - tau c:
// their Eq. 6 with z inward, where -U_z = s (lost in Watt and Policarpo 2005, chapter 5). Its discriminant is
// s^2 + 4 k c tau. d = sigma / sz; the perpendicular is defined in tangent space, because the scaling to
// relief space doesn't preserve right angles.
//
// Eq. 7 is used where there is no such point (discriminant < 0 on a concave base) and where the ray is
// parallel to N, so that U is undefined.
//
// surfaceA: s (0 if Eq. 7 is used for the whole ray), k, 0, 0.

// Below this sine, U is a difference of nearly equal vectors with less than 1e-4 of their length, so its
// direction keeps only about three of the seven digits of a float.
const float kHeadOnSine = 1e-4;

// sigma in world units at `tau` along the ray. The form 2 C / (-B -+ root) doesn't divide by A, which is 0 on
// a plane and along a cylinder's axis.
float depthAlong(float s, float c, float k, float tau) {
    float below = tau * (c - k * s * s * tau); // -C, and Eq. 7's depth
    float discriminant = s * s + 4.0 * k * c * tau;
    if (s == 0.0 || discriminant < 0.0) return below;
    return 2.0 * below / (s * (1.0 + 2.0 * k * c * tau) + sqrt(discriminant));
}

// End of the search in world units, and the depth there. sigma = h at the positive root of
//     k s^2 tau^2 + (2 k s c h - c) tau + h (s + k c^2 h) = 0, whose discriminant is c^2 - 4 k s h;
// sigma = 0 on the quadric, at tau = c / (k s^2). On a concave quadric the perpendicular no longer meets it
// from tau = s^2 / (-4 k c) on, which is before sigma reaches h if s (2 - s^2) < -4 k c^2 h. There, Eq. 7's
// depth is less than half of sigma and continues to h.
vec2 perpendicularEnd(float s, float c, float k, float h) {
    if (s == 0.0 || (k < 0.0 && s * (2.0 - s * s) < -4.0 * k * c * c * h)) return searchEnd(c / h, k * s * s / h);
    float discriminant = c * c - 4.0 * k * s * h;
    if (discriminant < 0.0) return vec2(c / (k * s * s), 0.0);
    return vec2(2.0 * h * (s + k * c * c * h) / (c * (1.0 - 2.0 * k * s * h) + sqrt(discriminant)), 1.0);
}

bool enterRelief(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray) {
    vec2 scale = reliefScale(frame);
    vec2 across = direction.xy * scale; // along the unit tangents, per world unit
    float c = direction.z * frame.depthWorld;
    float tangentCosine = dot(frame.positionS, frame.positionT) / max(scale.x * scale.y, 1e-30);
    float s = sqrt(max(dot(across, across) + 2.0 * tangentCosine * across.x * across.y, 0.0));
    bool headOn = s < kHeadOnSine;
    float k = headOn ? 0.0 : quadricFall(frame.curvature, across / s);
    if (headOn) s = 0.0;
    vec2 end = c > kGrazingCosine ? perpendicularEnd(s, c, k, frame.depthWorld) : vec2(0.0);
    ray = ReliefRay(st, direction.xy * end.x, end.y, 0.0, end.x, c, scale, frame.depthWorld, vec4(s, k, 0.0, 0.0), vec4(0.0));
    return c > kGrazingCosine;
}

// d is exactly endDepth at t = 1.
vec3 surfacePosition(ReliefRay ray, float t) {
    float depth = depthAlong(ray.surfaceA.x, ray.cosine, ray.surfaceA.y, ray.lengthWorld * t) / ray.depthWorld;
    return vec3(ray.st + ray.stTravel * t, t >= 1.0 ? ray.endDepth : depth);
}

// From the derivative of A sigma^2 + B sigma + C = 0 with respect to tau, or of Eq. 7 where it is used.
float surfaceDescent(ReliefRay ray, float t) {
    float s = ray.surfaceA.x, k = ray.surfaceA.y, c = ray.cosine, tau = ray.lengthWorld * t;
    float discriminant = s * s + 4.0 * k * c * tau;
    float descent = c - 2.0 * k * s * s * tau;
    if (s > 0.0 && discriminant > 0.0)
        descent = (descent - 2.0 * k * s * c * depthAlong(s, c, k, tau)) / sqrt(discriminant);
    return descent * ray.lengthWorld / ray.depthWorld;
}

// The frame below the hit along the fragment's normal, as on `quadric`: the surface D_U = D(s, t) depends on
// the ray, so it has no frame.
ReliefFrame frameAt(ReliefFrame frame, ReliefRay ray, float t) { return tiltedFrame(frame, ray.stTravel * t); }
