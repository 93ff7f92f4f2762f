// Secant relief mapping: equal steps to the first sample inside the relief, then secant steps within the
// interval until the point is within `tolerance` of the relief (Risser, Shah, Pattanaik 2007).
//
// E1 to E4 refer to the project's errata. The printed update is regula falsi, in which one end may never
// move; the Illinois variant halves the gap of an end that is retained twice (E1). The listing returns the
// depth *sampled* at the point, which is an undamped parallax step away from the point itself and worse where
// the relief is steeper than the ray (E2). Its variables are called depth but compare heights (E3). It is
// parametrized by horizontal distance, which gives infinity times 0 for a perpendicular ray; here depth is
// the parameter (E4).
//
// Gap: D - d, > 0 outside the relief. Over a quadric, d isn't linear in t; the secants are those of the gap
// as a function of t.

// For sampled_depth, t plus the gap divided by the ray's descent, which on a flat base gives t = D up to
// rounding.
float answerAt(ReliefRay ray, float t, float gap) {
    if (answer == answer_intersection) return t;
    float descent = descentAt(ray, t);
    return descent > kGrazingCosine ? clamp(t + gap / descent, 0.0, 1.0) : t;
}

// Refines the hit between t = `outside` with gapOutside > 0 and `inside` with gapInside <= 0.
float refine(ReliefRay ray, float outside, float gapOutside, float inside, float gapInside) {
    float t = inside, gap = gapInside;
    int lastSide = 0; // which end moved last: 1 outside, -1 inside
    for (int i = 0; i < max_iterations; ++i) {
        countIteration();
        t = outside + (inside - outside) * (gapOutside / (gapOutside - gapInside));
        vec3 position = reliefPosition(ray, t);
        gap = reliefDepth(position.xy) - position.z;
        if (abs(gap) <= tolerance) break;
        int side = gap > 0.0 ? 1 : -1;
        bool stays = method == method_illinois && side == lastSide;
        if (side > 0) {
            outside = t;
            gapOutside = gap;
            if (stays) gapInside *= 0.5;
        } else {
            inside = t;
            gapInside = gap;
            if (stays) gapOutside *= 0.5;
        }
        lastSide = side;
    }
    return answerAt(ray, t, gap);
}

ReliefHit traceRelief(ReliefRay ray) {
    float outside = 0.0, gapOutside = reliefDepth(reliefPosition(ray, 0.0).xy);
    if (gapOutside <= 0.0) return hitAt(ray, 0.0);
    for (int i = 1; i <= linear_steps; ++i) {
        float t = float(i) / float(linear_steps);
        vec3 position = reliefPosition(ray, t);
        float gap = reliefDepth(position.xy) - position.z;
        if (gap <= 0.0) return hitAt(ray, refine(ray, outside, gapOutside, t, gap));
        outside = t;
        gapOutside = gap;
    }
    return missed();
}
