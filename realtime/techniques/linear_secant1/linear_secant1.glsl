// Parallax occlusion mapping: equal steps to the first sample inside the relief, then the relief between the last two samples is
// taken for a straight line and cut with the ray, once.
//
// Distance outside the relief is D - d. Depth is the parameter (E4 of the project's errata: horizontal distance leaves a ray from
// straight above with infinity times 0). Over a quadric d isn't linear in t and the cut is that of the ray's chord.

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
