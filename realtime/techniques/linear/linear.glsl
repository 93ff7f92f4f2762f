// Steep parallax mapping: equal depth steps; the first sample inside the relief is the hit.
//
// All samples are tested, including the last one: on a flat base it is at depth 1, which is always inside
// (the listing of Watt and Policarpo, chapter 5, L5.3, omits it and makes the bottom of the map transparent:
// E24 of the project's errata).

ReliefHit traceRelief(ReliefRay ray) {
    for (int i = 1; i <= linear_steps; ++i) {
        float t = float(i) / float(linear_steps);
        vec3 position = reliefPosition(ray, t);
        if (reliefDepth(position.xy) <= position.z) return hitAt(ray, t);
    }
    return missed();
}
