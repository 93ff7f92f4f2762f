// The harness of a relief technique: builds the rays, calls the search, turns its hits into channels.

flat in vec4 vTriangleStAB;
flat in vec2 vTriangleStC;

uniform float uShadowBias; // relief depth

// Normal of P = S - depthWorld * d * normal from its derivatives along s and t; `frame`: of the base at the hit.
vec3 reliefNormal(ReliefFrame frame, vec2 st) {
    vec2 fall = frame.depthWorld * reliefDepthGradient(st);
    vec3 positionS = frame.positionS - frame.normal * fall.x;
    vec3 positionT = frame.positionT - frame.normal * fall.y;
    vec3 across = cross(directionOr(positionS, vec3(0.0)), directionOr(positionT, vec3(0.0)));
    if (dot(across, frame.normal) < 0.0) across = -across; // mirrored texture coordinates
    return directionOr(across, frame.normal);
}

// 1 where a second search along the light is stopped above the point (Watt and Policarpo 2005, chapter 5, listing 5.3).
float castShadow(ReliefFrame frame, vec3 positionRelief, vec3 toLight) {
    vec3 direction = reliefDirection(frame, -toLight);
    if (direction.z * frame.depthWorld <= kGrazingCosine) return 1.0; // the light is below the tangent plane
    vec2 stEntry = positionRelief.xy - direction.xy * (positionRelief.z / direction.z);
    ReliefRay ray;
    if (!enterRelief(frame, stEntry, direction, ray)) return 0.0;
    ReliefHit hit = traceRelief(ray);
    return hit.hit && reliefPosition(ray, hit.t).z < positionRelief.z - uShadowBias ? 1.0 : 0.0;
}

float doubledArea(vec2 a, vec2 b, vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// Whether st belongs to the triangle drawn (Premecz 2006, section 1.1). One without area holds everything.
bool insideTriangle(vec2 st) {
    vec2 a = vTriangleStAB.xy, b = vTriangleStAB.zw, c = vTriangleStC;
    float whole = doubledArea(a, b, c);
    return doubledArea(a, b, st) * whole >= 0.0 && doubledArea(b, c, st) * whole >= 0.0 &&
           doubledArea(c, a, st) * whole >= 0.0;
}

void main() {
    ReliefFrame frame = fragmentFrame();
    vec3 toCamera = directionToCamera(vPosition);
    ReliefRay ray;
    if (!enterRelief(frame, frame.st, reliefDirection(frame, -toCamera), ray)) discard;
    ReliefHit hit = traceRelief(ray);
    if (!hit.hit || (kTriangleBounds && !insideTriangle(hit.st))) discard;
    int iterations = gIterations;

    SurfacePoint point;
    point.position = vPosition - toCamera * (hit.t * ray.lengthWorld);
    point.normal = reliefNormal(frameAt(frame, ray, hit.t), hit.st);
    point.st = hit.st;
    vec3 positionRelief = vec3(hit.st, reliefPosition(ray, hit.t).z);
    float shadow[kLightSlots];
    for (int i = 0; i < kLightCount; ++i) {
        vec3 toLight = directionToLight(i, point.position);
        shadow[i] = 1.0;
        if (dot(point.normal, toLight) > 0.0)
            shadow[i] = kCastShadows ? castShadow(frame, positionRelief, toLight) : 0.0;
    }
    float depth = planarDepth(kDepthCorrection ? point.position : vPosition);
    writePoint(point, point.normal, depth, shadow, vec3(gHeightLookups, gBakedLookups, iterations),
               frame.curvature);
}
