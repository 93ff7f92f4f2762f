// Iterative parallax mapping: the slope step is repeated from its result on the ray (Premecz, section 3).
//
// tau += sz n_z g, with g = D - d at the current point; in t, on a flat base whose ray is sz / cosine long, t
// += n_z cosine g. Near a hit, each iteration multiplies the error by 1 - n . E, so it converges where the
// relief faces the eye, slowly at grazing angles (E8 of the project's errata, which also has the equation's
// right-hand side). `damping = none` divides by n . E, which is Newton's method, except where the plane faces
// away, where it uses the damped step.
//
// The printed listing starts from a third texture coordinate that is never set; here t = 0. The normal must
// be adapted to the relief's scale; `rescale_normal = false` is the printed code, which only scales the
// height (E7). scale and bias: parallax/parallax.glsl.

// Below this n . E / (n_z cosine) the plane counts as facing away: Newton's step would be a thousand times
// the gap.
const float kEdgeOn = 1e-3;

// The unit normal of the relief scaled in depth by `scale`.
vec3 scaledNormal(vec3 normal) {
    return rescale_normal ? normalize(vec3(normal.xy * scale, normal.z)) : normal;
}

// Step in t for the gap at a point with this normal.
float stepOf(ReliefRay ray, vec3 normal, float gap) {
    float damped = gap * normal.z * max(ray.cosine, 0.0);
    if (damping == damping_normal) return damped;
    float facing = 1.0 - dot(normal.xy, ray.scaleWorld * ray.stTravel) / (normal.z * ray.depthWorld);
    return facing > kEdgeOn ? gap / facing : damped;
}

ReliefHit traceRelief(ReliefRay ray) {
    float t = 0.0, low = min(bias, 0.0), high = max(scale + bias, 0.0);
    for (int i = 0; i < iterations; ++i) {
        countIteration();
        vec3 position = reliefPosition(ray, t);
        vec4 relief = normalAndDepth(ray, position.xy);
        float gap = scale * relief.w + bias - position.z;
        // The relief is within its layer.
        t = clamp(t + stepOf(ray, scaledNormal(relief.xyz), gap), low, high);
    }
    return hitAt(ray, t);
}
