// Relief mapping: equal steps to the first sample inside the relief, then bisection of the last interval.
//
// The bisection starts with the interval found by the linear search (the listing of Premecz, section 2.3,
// restarts at depth 1 with steps too small to return to it: E6 of the project's errata). On a flat base the
// last sample is at depth 1, which is always inside (E24: chapter 5's L5.3 omits it and makes the bottom of
// the map transparent).

// `steps = adaptive`: linear_steps for a perpendicular view, up to twice as many at grazing angles (Premecz,
// section 2.3).
int linearStepCount(ReliefRay ray) {
    if (steps == steps_fixed) return linear_steps;
    return int(ceil(mix(2.0, 1.0, clamp(ray.cosine, 0.0, 1.0)) * float(linear_steps)));
}

ReliefHit traceRelief(ReliefRay ray) {
    float outside = 0.0, inside = -1.0;
    int stepCount = linearStepCount(ray);
    for (int i = 1; i <= stepCount; ++i) {
        float t = float(i) / float(stepCount);
        vec3 position = reliefPosition(ray, t);
        bool isInside = reliefDepth(position.xy) <= position.z;
        // Keep the first hit; without early_exit the loop continues, as in chapter 5's L5.3.
        if (inside < 0.0) {
            if (isInside)
                inside = t;
            else
                outside = t;
        }
        if (early_exit && isInside) break;
    }
    if (inside < 0.0) return missed();

    for (int i = 0; i < binary_steps; ++i) {
        countIteration();
        float middle = 0.5 * (outside + inside);
        vec3 position = reliefPosition(ray, middle);
        float gap = reliefDepth(position.xy) - position.z;
        if (tolerance > 0.0 && abs(gap) <= tolerance) return hitAt(ray, middle);
        if (gap <= 0.0)
            inside = middle;
        else
            outside = middle;
    }
    return hitAt(ray, inside);
}
