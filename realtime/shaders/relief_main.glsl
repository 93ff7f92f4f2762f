// Fragment shader of a relief technique: traces the view ray and shadow rays with the search and writes the
// channels.

uniform float uShadowBias; // relief depth

// Normal of P = S - depthWorld * d * normal from its derivatives along s and t; `frame` is that of the base
// at the hit.
vec3 reliefNormal(ReliefFrame frame, vec2 st) {
    vec2 fall = frame.depthWorld * reliefDepthGradient(st);
    vec3 positionS = frame.positionS - frame.normal * fall.x;
    vec3 positionT = frame.positionT - frame.normal * fall.y;
    vec3 across = cross(directionOr(positionS, vec3(0.0)), directionOr(positionT, vec3(0.0)));
    if (dot(across, frame.normal) < 0.0) across = -across; // mirrored texture coordinates
    return directionOr(across, frame.normal);
}

// 1 if a second search along the light's ray hits the relief above the point (Watt and Policarpo 2005,
// chapter 5, listing 5.3).
float reliefShadow(ReliefFrame frame, vec3 positionRelief, vec3 toLight) {
    vec3 direction = reliefDirection(frame, -toLight);
    if (direction.z * frame.depthWorld <= kGrazingCosine) return 1.0; // the light is below the tangent plane
    vec2 stEntry = positionRelief.xy - direction.xy * (positionRelief.z / direction.z);
    ReliefRay ray;
    if (!enterRelief(frame, stEntry, direction, ray)) return 0.0;
    ReliefHit hit = traceRelief(ray);
    return hit.hit && reliefPosition(ray, hit.t).z < positionRelief.z - uShadowBias ? 1.0 : 0.0;
}

// uShadowBias converted to a distance along the light's ray, world units.
float searchMargin(ReliefFrame frame, vec3 toLight) {
    return uShadowBias * frame.depthWorld / max(dot(frame.normal, toLight), kSteepestCosine);
}

void main() {
    FragmentHit found;
    if (!traceFragment(found)) discard;
    int iterations = gIterations;

    SurfacePoint point;
    point.position = found.position;
    point.normal = reliefNormal(frameAt(found.frame, found.ray, found.hit.t), found.hit.st);
    point.st = found.hit.st;
    vec3 positionRelief = vec3(found.hit.st, reliefPosition(found.ray, found.hit.t).z);
    float shadow[kLightSlots];
    for (int i = 0; i < kLightCount; ++i) {
        vec3 toLight = directionToLight(i, point.position);
        shadow[i] = 1.0;
        if (dot(point.normal, toLight) <= 0.0) continue;
        shadow[i] = 0.0;
        if (kReliefShadows) shadow[i] = reliefShadow(found.frame, positionRelief, toLight);
        if (kShadowMaps)
            shadow[i] = mapShadow(i, point.position, point.normal, toLight, searchMargin(found.frame, toLight));
    }
    float depth = planarDepth(kDepthCorrection ? point.position : vPosition);
    writePoint(point, point.normal, depth, shadow, vec3(gHeightLookups, gBakedLookups, iterations),
               found.frame.curvature);
}
