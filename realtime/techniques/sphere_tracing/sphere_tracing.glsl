// Sphere tracing in a distance field of the relief (Donnelly 2005, as described by Premecz 2006, section
// 2.4). The listing steps d in [0,1] by metric distances, but field and direction must have the same metric
// (TECHNIQUES E11); here both are in world units.
//
// `voxel` uses a distance valid in the whole voxel, so that its steps can't pass through the relief. The
// distance is 0 in voxels that intersect the relief; there the ray advances by half a voxel, samples the
// depth, and bisects the step that entered the relief. `trilinear` is the source's method, which only steps
// through the filtered field.

ReliefHit bisected(ReliefRay ray, float outside, float inside) {
    for (int i = 0; i < binary_steps; ++i) {
        countIteration();
        float middle = 0.5 * (outside + inside);
        vec3 position = reliefPosition(ray, middle);
        if (reliefDepth(position.xy) <= position.z)
            inside = middle;
        else
            outside = middle;
    }
    return hitAt(ray, inside);
}

ReliefHit traceRelief(ReliefRay ray) {
    float t = 0.0, outside = 0.0;
    vec3 voxels = abs(vec3(ray.stTravel, 1.0)) * vec3(distanceFieldSize()); // crossed from t = 0 to 1
    float minStep = 0.5 / max(max(voxels.x, voxels.y), voxels.z);
    for (int i = 0; i < sphere_steps; ++i) {
        vec3 position = reliefPosition(ray, t);
        if (t >= 1.0) break;
        countIteration();
        float free = field == field_voxel ? distanceOfVoxel(ray, position) : distanceTrilinear(ray, position);
        if (field == field_voxel && free <= 0.0) {
            if (reliefDepth(position.xy) <= position.z) return bisected(ray, outside, t);
        }
        outside = t;
        t = min(t + max(free / max(ray.lengthWorld, 1e-30), field == field_voxel ? minStep : 0.0), 1.0);
    }
    if (field == field_voxel && t >= 1.0) return bisected(ray, outside, 1.0);
    return hitAt(ray, t);
}
