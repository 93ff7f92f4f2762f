// Conservative cone stepping: each step advances to the point where the ray leaves the empty cone above the
// current point.
//
// With clearance g above that point, cone ratio c, st speed r and descent m per unit of t, the step satisfies
// r dt = c (g - m dt) (Policarpo and Oliveira 2007, section 18.3, Eqs 1 to 4, which are missing in the text:
// derived in TECHNIQUES section 1). On a curved base, m is an upper bound of the remaining descent. The steps
// converge to the relief without reaching it; after the last step the current point is the hit.

float coneRatio(vec2 st) {
    if (cone_lookup == cone_lookup_cell) return coneOfCell(st).r;
    if (cone_lookup == cone_lookup_min_of_four) return coneMinOfFour(st).r;
    if (cone_lookup == cone_lookup_bilinear) return coneBilinear(st).r;
    return coneOfNearestTexel(st).r;
}

ReliefHit traceRelief(ReliefRay ray) {
    float speed = length(ray.stTravel);
    float t = 0.0;
    for (int i = 0; i < cone_steps; ++i) {
        vec3 position = reliefPosition(ray, t);
        float clearance = reliefDepth(position.xy) - position.z;
        if (clearance <= tolerance) return hitAt(ray, t);
        countIteration();
        float cone = coneRatio(position.xy);
        t += cone * clearance / max(speed + cone * steepestDescent(ray, t), 1e-30);
        if (t >= 1.0) {
            if (ray.endDepth < 1.0) return missed(); // left a curved layer through the top
            return hitAt(ray, 1.0);
        }
    }
    return hitAt(ray, t);
}
