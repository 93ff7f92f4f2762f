// Cone stepping with a ratio for each quarter of directions. The source says nothing of how one is chosen: the quarter the
// ray travels in, +-45 degrees around an axis of the map. A ray passes over the point its cone stands on and so stays in
// one quarter for the whole step.

float ofQuarter(vec4 ratios, vec2 way) {
    if (abs(way.x) >= abs(way.y)) return way.x >= 0.0 ? ratios.x : ratios.y;
    return way.y >= 0.0 ? ratios.z : ratios.w;
}

vec4 coneRatios(vec2 st) {
    if (cone_lookup == cone_lookup_cell) return coneOfCell(st);
    if (cone_lookup == cone_lookup_min_of_four) return coneMinOfFour(st);
    if (cone_lookup == cone_lookup_bilinear) return coneBilinear(st);
    return coneOfNearestTexel(st);
}

ReliefHit traceRelief(ReliefRay ray) {
    float speed = length(ray.stTravel);
    float t = 0.0;
    for (int i = 0; i < cone_steps; ++i) {
        vec3 position = reliefPosition(ray, t);
        float clearance = reliefDepth(position.xy) - position.z;
        if (clearance <= tolerance) return hitAt(ray, t);
        countIteration();
        float cone = ofQuarter(coneRatios(position.xy), ray.stTravel);
        t += cone * clearance / max(speed + cone * steepestDescent(ray, t), 1e-30);
        if (t >= 1.0) {
            if (ray.endDepth < 1.0) return missed();
            return hitAt(ray, 1.0);
        }
    }
    return hitAt(ray, t);
}
