// Bisection of the whole search interval, without a linear search.
//
// It finds some intersection of the ray with the relief, not necessarily the first (Watt and Policarpo,
// chapter 5, figure 5.12; Policarpo and Oliveira, GPU Gems 3, figure 18-4). It serves as a baseline.
//
// `interval = printed`: the listing of Premecz, section 2.3, starts at the top with a step of 1 / (2
// binary_steps), so that the halved steps together can't get deeper than 1 / binary_steps (E6 of the
// project's errata: the first size must be that of the interval, 1).
//
// Over a quadric, a ray may leave the layer through the top, so that its end is outside the relief too. The
// bisection moves toward the end while the midpoints are outside; the fragment is discarded unless one of
// them was inside.

ReliefHit bisectInterval(ReliefRay ray) {
    float outside = 0.0, inside = 1.0;
    bool found = ray.endDepth >= 1.0; // depth 1 is inside whatever the map
    for (int i = 0; i < binary_steps; ++i) {
        countIteration();
        float middle = 0.5 * (outside + inside);
        vec3 position = reliefPosition(ray, middle);
        if (reliefDepth(position.xy) <= position.z) {
            inside = middle;
            found = true;
        } else {
            outside = middle;
        }
    }
    if (!found) return missed();
    return hitAt(ray, inside);
}

// Returns the final position; the listing's result is undefined if all samples are outside.
ReliefHit walkAsPrinted(ReliefRay ray) {
    float t = 0.0, size = 1.0 / float(binary_steps);
    for (int i = 0; i < binary_steps; ++i) {
        countIteration();
        size *= 0.5;
        vec3 position = reliefPosition(ray, t);
        t += reliefDepth(position.xy) <= position.z ? -size : size;
    }
    return hitAt(ray, max(t, 0.0));
}

ReliefHit traceRelief(ReliefRay ray) {
    if (interval == interval_printed) return walkAsPrinted(ray);
    return bisectInterval(ray);
}
