// Sphere tracing in a distance field of the relief (Donnelly 2005, as told by Premecz 2006, section 2.4). The listing steps
// d in [0,1] by metric distances; field and direction must share one metric (TECHNIQUES E11): both are in world units here.
//
// `voxel` reads a distance that holds everywhere in the voxel, so that no step can pass through the relief. It is 0 in the voxels
// that touch the relief; there the ray goes on by half a voxel, looks the depth up, and bisects the step that entered.
// `trilinear` is the field as the source has it: steps until they run out.

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
    float leastStep = 0.5 / max(max(voxels.x, voxels.y), voxels.z);
    for (int i = 0; i < sphere_steps; ++i) {
        vec3 position = reliefPosition(ray, t);
        if (t >= 1.0) break;
        countIteration();
        float free = field == field_voxel ? distanceOfVoxel(ray, position) : distanceTrilinear(ray, position);
        if (field == field_voxel && free <= 0.0) {
            if (reliefDepth(position.xy) <= position.z) return bisected(ray, outside, t);
        }
        outside = t;
        t = min(t + max(free / max(ray.lengthWorld, 1e-30), field == field_voxel ? leastStep : 0.0), 1.0);
    }
    if (field == field_voxel && t >= 1.0) return bisected(ray, outside, 1.0);
    return hitAt(ray, t);
}
