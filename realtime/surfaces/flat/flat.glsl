// The base is the tangent plane of the fragment: rays are straight in relief space.

bool enterRelief(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray) {
    bool descends = direction.z * frame.depthWorld > kGrazingCosine;
    float lengthWorld = descends ? 1.0 / direction.z : 0.0; // a grazing ray ends at the polygon
    ray = ReliefRay(st, direction.xy * lengthWorld, 1.0, 0.0, lengthWorld, direction.z * frame.depthWorld,
                    reliefScale(frame), frame.depthWorld, vec4(0.0), vec4(0.0));
    return true;
}

vec3 reliefPosition(ReliefRay ray, float t) { return vec3(ray.st + ray.stTravel * t, t); }

float descentAt(ReliefRay ray, float t) { return 1.0; }

float steepestDescent(ReliefRay ray, float t) { return 1.0; }

ReliefFrame frameAt(ReliefFrame frame, ReliefRay ray, float t) { return frame; }
