// Relaxed cone stepping: cones a ray may enter the relief in, but not leave it. The first point visited inside the relief has
// the first hit between it and the point before, and a bisection or the secant finds it (Policarpo and Oliveira 2007, section
// 18.4, listing 18-3; the listing forgets to hand its result back, TECHNIQUES E23).
//
// Cones end at the height of the point they stand on: over level ground the steps come ever closer and never arrive. Where they run
// out, or end within `tolerance`, the search goes on between the entry, or the last point, and there, as in the listing.

float coneRatio(vec2 st) {
    if (cone_lookup == cone_lookup_cell) return coneOfCell(st).r;
    if (cone_lookup == cone_lookup_min_of_four) return coneMinOfFour(st).r;
    if (cone_lookup == cone_lookup_bilinear) return coneBilinear(st).r;
    return coneOfNearestTexel(st).r;
}

// Clearance above the relief at t: positive outside of it.
float clearanceAt(ReliefRay ray, float t) {
    vec3 position = reliefPosition(ray, t);
    return reliefDepth(position.xy) - position.z;
}

// Between `outside` and `inside`, whose clearances are given.
float refined(ReliefRay ray, float outside, float inside, float above, float below) {
    for (int i = 0; i < refine_steps; ++i) {
        countIteration();
        float share = 0.5;
        if (refine == refine_secant && above > below) share = clamp(above / (above - below), 0.0, 1.0);
        float middle = outside + (inside - outside) * share;
        float clearance = clearanceAt(ray, middle);
        if (clearance <= 0.0) {
            inside = middle;
            below = clearance;
            above *= refine == refine_secant ? 0.5 : 1.0; // Illinois: or one end could stay for ever (TECHNIQUES E1)
        } else {
            outside = middle;
            above = clearance;
            below *= refine == refine_secant ? 0.5 : 1.0;
        }
    }
    return inside;
}

ReliefHit traceRelief(ReliefRay ray) {
    float speed = length(ray.stTravel);
    float t = 0.0, outside = 0.0, above = 0.0, clearance = 0.0;
    for (int i = 0; i < cone_steps; ++i) {
        vec3 position = reliefPosition(ray, t);
        clearance = reliefDepth(position.xy) - position.z;
        if (clearance <= tolerance) break;
        if (t >= 1.0) {
            if (ray.endDepth < 1.0) return missed();
            break;
        }
        countIteration();
        outside = t;
        above = clearance;
        float cone = coneRatio(position.xy);
        t = min(t + cone * clearance / max(speed + cone * steepestDescent(ray, t), 1e-30), 1.0);
    }
    if (t <= 0.0) return hitAt(ray, 0.0);
    if (clearance > tolerance) { // the last step's end wasn't looked at
        clearance = clearanceAt(ray, t);
        if (clearance > 0.0 && t >= 1.0 && ray.endDepth < 1.0) return missed();
    }
    if (bracket == bracket_whole_ray) {
        outside = 0.0;
        above = clearanceAt(ray, 0.0);
    }
    return hitAt(ray, refined(ray, outside, t, above, min(clearance, 0.0)));
}
