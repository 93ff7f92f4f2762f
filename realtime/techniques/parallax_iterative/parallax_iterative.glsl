// Iterative parallax mapping: the slope step repeated from where it ended, on the ray (Premecz, section 3).
//
// tau += sz n_z g, with g = D - d at the current point; in t, on a flat base whose ray is sz / cosine long, t += n_z cosine g. Near a
// hit each round leaves the error times 1 - n . E: it converges where the relief faces the eye, slowly at grazing angles (E8 of
// the project's errata, which also has the equation's right-hand side). `damping = none` divides by n . E again, which is Newton's
// method; where the plane faces away it takes the damped step.
//
// The printed listing starts from a third texture coordinate it never sets; here t = 0. The normal has to follow the relief's scale:
// `rescale_normal = false` is the printed code, which scales the height alone (E7). scale and bias: parallax/parallax.glsl.

// Below this n . E / (n_z cosine) the plane is taken to face away: Newton's step would be a thousand gaps long.
const float kEdgeOn = 1e-3;

// A unit normal of the relief `scale` times as deep.
vec3 scaledNormal(vec3 normal) {
    return rescale_normal ? normalize(vec3(normal.xy * scale, normal.z)) : normal;
}

// Change of t for the gap at a point with this normal.
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
        t = clamp(t + stepOf(ray, scaledNormal(relief.xyz), gap), low, high); // no point of the relief is outside of its layer
    }
    return hitAt(ray, t);
}
