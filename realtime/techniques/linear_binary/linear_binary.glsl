// Relief mapping: equal steps to the first sample inside the relief, then bisection of the last step.
//
// The bisection starts with the bracket the linear search left (the listing of Premecz, section 2.3, starts anew at depth
// 1 with steps too small to come back: E6 of the project's errata). On a flat base the last step is depth 1, which is always
// inside (E24: chapter 5's L5.3 leaves that sample out and makes the bottom of the map transparent).

// `steps = adaptive`: from linear_steps straight from above to twice as many along the surface (Premecz, section 2.3).
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
        if (inside < 0.0) { // not found yet: without early_exit the loop goes on, as chapter 5's L5.3 does
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
