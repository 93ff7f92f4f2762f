// Parallax mapping with slope, the hit itself: the relief is taken for the plane through the point below the fragment with the normal
// stored there, and the ray cut with it (Premecz, section 3, before its "safe" form).
//
// With D(t) = d0 + t grad D . stTravel and d = t on a flat base, t = d0 / (1 - grad D . stTravel). The denominator is
// (n . E) / (n_z cosine), E toward the eye: where the plane faces away from it (n . E <= 0) the cut lies behind the eye, and the
// safe form t = d0 n_z cosine is the answer. No point of the relief is outside of its layer: t is kept in it.
//
// The normal has to follow the relief's scale: `rescale_normal = false` is the printed code, which scales the height alone (E7 of the
// project's errata). scale and bias: parallax/parallax.glsl.

// Below this n . E / (n_z cosine) the plane is taken to face away: t would be a thousand times the depth below the fragment.
const float kEdgeOn = 1e-3;

// A unit normal of the relief `scale` times as deep.
vec3 scaledNormal(vec3 normal) {
    return rescale_normal ? normalize(vec3(normal.xy * scale, normal.z)) : normal;
}

// Change of the relief's depth from t = 0 to 1 along the plane: n is along (D_s sz / sx, D_t sz / sy, 1).
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
