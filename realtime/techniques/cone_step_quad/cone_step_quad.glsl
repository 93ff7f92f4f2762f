// Cone stepping with a separate ratio for each quadrant of directions. The source doesn't define the
// quadrants; here they are +-45 degrees around the map's axes, and the ray's direction selects one. A step
// starts above the cone's apex, so the ray stays in one quadrant during the step.

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
