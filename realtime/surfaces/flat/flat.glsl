// The base is the tangent plane of the fragment: rays are straight in relief space.

bool enterRelief(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray) {
    float cosine = max(direction.z * frame.depthWorld, 0.0);
    bool descends = cosine > kGrazingCosine;
    float lengthWorld = descends ? 1.0 / direction.z : 0.0; // a grazing ray ends at the polygon
    ray = ReliefRay(st, direction.xy * lengthWorld, 1.0, 0.0, lengthWorld, cosine, reliefScale(frame),
                    frame.depthWorld, vec4(0.0), vec4(0.0));
    return true;
}

vec3 surfacePosition(ReliefRay ray, float t) { return vec3(ray.st + ray.stTravel * t, t); }

float surfaceDescent(ReliefRay ray, float t) { return 1.0; }

float surfaceSteepestDescent(ReliefRay ray, float t) { return 1.0; }

ReliefFrame frameAt(ReliefFrame frame, ReliefRay ray, float t) { return frame; }
