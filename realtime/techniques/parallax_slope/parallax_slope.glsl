// Parallax mapping with slope, the "safe" form: assumes that the relief is the plane through the point below
// the fragment with the normal stored there, and omits the division by normal . eye (Premecz, section 3).
//
// The distance along the unit ray is tau = d0 sz n_z. On a flat base, whose ray is sz / cosine long, that is
// t = d0 n_z cosine.
//
// The normal must be adapted to the relief's scale; `rescale_normal = false` is the printed code, which only
// scales the height (E7 of the project's errata). scale and bias: parallax/parallax.glsl.

// The unit normal of the relief scaled in depth by `scale`.
vec3 scaledNormal(vec3 normal) {
    return rescale_normal ? normalize(vec3(normal.xy * scale, normal.z)) : normal;
}

ReliefHit traceRelief(ReliefRay ray) {
    vec4 relief = normalAndDepth(ray, ray.st);
    return hitAt(ray, (scale * relief.w + bias) * scaledNormal(relief.xyz).z * ray.cosine);
}
