// Parallax mapping with slope, exact form: intersects the ray with the plane through the point below the
// fragment with the normal stored there (Premecz, section 3, before its "safe" form).
//
// With D(t) = d0 + t grad D . stTravel and d = t on a flat base, t = d0 / (1 - grad D . stTravel). The
// denominator is (n . E) / (n_z cosine), E toward the eye: where the plane faces away from it (n . E <= 0),
// the intersection is behind the eye, and the safe form t = d0 n_z cosine is used. t is clamped to the
// relief's layer.
//
// The normal must be adapted to the relief's scale; `rescale_normal = false` is the printed code, which only
// scales the height (E7 of the project's errata). scale and bias: parallax/parallax.glsl.

// Below this n . E / (n_z cosine) the plane counts as facing away: t would be a thousand times the depth
// below the fragment.
const float kEdgeOn = 1e-3;

// The unit normal of the relief scaled in depth by `scale`.
vec3 scaledNormal(vec3 normal) {
    return rescale_normal ? normalize(vec3(normal.xy * scale, normal.z)) : normal;
}

// Change of the plane's depth from t = 0 to 1; n is parallel to (D_s sz / sx, D_t sz / sy, 1).
float planeSlope(ReliefRay ray, vec3 normal) {
    return dot(normal.xy, ray.scaleWorld * ray.stTravel) / (normal.z * ray.depthWorld);
}

ReliefHit traceRelief(ReliefRay ray) {
    vec4 relief = normalAndDepth(ray, ray.st);
    vec3 normal = scaledNormal(relief.xyz);
    float depth = scale * relief.w + bias;
    float facing = 1.0 - planeSlope(ray, normal);
    if (!(facing > kEdgeOn)) return hitAt(ray, depth * normal.z * ray.cosine);
    return hitAt(ray, clamp(depth / facing, min(bias, 0.0), max(scale + bias, 0.0)));
}
