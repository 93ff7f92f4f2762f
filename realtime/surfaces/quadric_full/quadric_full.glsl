// Depth below a quadric with its cross term, along the fragment's normal: D_z, shaders/quadric_base.glsl.

bool enterRelief(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray) {
    return enterVertical(frame, frame.curvature, st, direction, ray);
}

vec3 reliefPosition(ReliefRay ray, float t) { return verticalPosition(ray, t); }

float descentAt(ReliefRay ray, float t) { return verticalDescent(ray, t); }

float steepestDescent(ReliefRay ray, float t) { return verticalSteepest(ray, t); }

ReliefFrame frameAt(ReliefFrame frame, ReliefRay ray, float t) { return tiltedFrame(frame, ray.stTravel * t); }
