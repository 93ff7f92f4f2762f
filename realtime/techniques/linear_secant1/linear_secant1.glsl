// Parallax occlusion mapping: equal steps to the first sample inside the relief, then one secant step, which
// intersects the ray with the straight line between the last two samples of the relief.
//
// The gap outside the relief is D - d. Depth is the parameter (E4 of the project's errata: horizontal
// distance gives infinity times 0 for a perpendicular ray). Over a quadric, d isn't linear in t, and the
// chord of the ray is intersected.

ReliefHit traceRelief(ReliefRay ray) {
    float outside = 0.0, gapOutside = reliefDepth(reliefPosition(ray, 0.0).xy);
    if (gapOutside <= 0.0) return hitAt(ray, 0.0);
    for (int i = 1; i <= linear_steps; ++i) {
        float t = float(i) / float(linear_steps);
        vec3 position = reliefPosition(ray, t);
        float gap = reliefDepth(position.xy) - position.z;
        if (gap <= 0.0) {
            countIteration();
            return hitAt(ray, outside + (t - outside) * (gapOutside / (gapOutside - gap)));
        }
        outside = t;
        gapOutside = gap;
    }
    return missed();
}
