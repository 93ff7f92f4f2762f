// Relief mapping: equal steps to the first sample inside the relief, then bisection of the last step.
//
// The bisection starts with the bracket the linear search left (the listing of Premecz, section 2.3, starts anew at depth
// 1 with steps too small to come back). On a flat base the last step is depth 1, which is always inside.

ReliefHit traceRelief(ReliefRay ray) {
    float outside = 0.0, inside = -1.0;
    for (int i = 1; i <= linear_steps; ++i) {
        float t = float(i) / float(linear_steps);
        vec3 position = reliefPosition(ray, t);
        if (reliefDepth(position.xy) <= position.z) {
            inside = t;
            break;
        }
        outside = t;
    }
    if (inside < 0.0) return missed();

    for (int i = 0; i < binary_steps; ++i) {
        float middle = 0.5 * (outside + inside);
        vec3 position = reliefPosition(ray, middle);
        if (reliefDepth(position.xy) <= position.z)
            inside = middle;
        else
            outside = middle;
    }
    return hitAt(ray, inside);
}
