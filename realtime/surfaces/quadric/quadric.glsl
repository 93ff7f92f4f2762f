// Depth below a quadric along the fragment's normal: D_z, shaders/quadric_base.glsl. Whether the quadric has a cross term is
// decided by the surface's input: "quadric" has none, "quadric_full" has one.

bool enterRelief(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray) {
    return enterVertical(frame, st, direction, ray);
}

vec3 surfacePosition(ReliefRay ray, float t) { return verticalPosition(ray, t); }

float surfaceDescent(ReliefRay ray, float t) { return verticalDescent(ray, t); }

float surfaceSteepestDescent(ReliefRay ray, float t) { return verticalSteepest(ray, t); }

// The frame at the hit differs from the fragment's.
ReliefFrame frameAt(ReliefFrame frame, ReliefRay ray, float t) { return tiltedFrame(frame, ray.stTravel * t); }
