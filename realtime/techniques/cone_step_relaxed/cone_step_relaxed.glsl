// Relaxed cone stepping: within a cone, a ray may enter the relief but not leave it. So the first hit lies
// between the first visited point inside the relief and the previous point, and is refined with bisection or
// the secant method (Policarpo and Oliveira 2007, section 18.4, listing 18-3; the listing doesn't return its
// result, TECHNIQUES E23).
//
// A cone's apex is on the relief, so on level ground the steps converge to the relief without reaching it.
// After the last step, or once within `tolerance`, the refinement uses the interval from the last point, or
// the entry, to the current point, as in the listing.

float coneRatio(vec2 st) {
    if (cone_lookup == cone_lookup_cell) return coneOfCell(st).r;
    if (cone_lookup == cone_lookup_min_of_four) return coneMinOfFour(st).r;
    if (cone_lookup == cone_lookup_bilinear) return coneBilinear(st).r;
    return coneOfNearestTexel(st).r;
}

// Clearance above the relief at t: positive outside.
float clearanceAt(ReliefRay ray, float t) {
    vec3 position = reliefPosition(ray, t);
    return reliefDepth(position.xy) - position.z;
}

// Refines the hit between `outside` and `inside`, whose clearances are given.
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
            // Illinois; otherwise one end may never move (TECHNIQUES E1).
            above *= refine == refine_secant ? 0.5 : 1.0;
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
    if (clearance > tolerance) { // the last step's end wasn't sampled
        clearance = clearanceAt(ray, t);
        if (clearance > 0.0 && t >= 1.0 && ray.endDepth < 1.0) return missed();
    }
    if (bracket == bracket_whole_ray) {
        outside = 0.0;
        above = clearanceAt(ray, 0.0);
    }
    return hitAt(ray, refined(ray, outside, t, above, min(clearance, 0.0)));
}
