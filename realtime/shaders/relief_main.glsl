// Fragment shader of a relief technique: traces the view ray and shadow rays with the search and writes the
// channels.

uniform float uShadowBias; // relief depth

// 1 from the front, -1 from behind: turns what points outward to the side that is seen.
const float kSeenSide = kFromBehind ? -1.0 : 1.0;

// Rounding of a search's t and st, relative to what they are computed from: a dozen operations in float, each
// accurate to 2^-24.
const float kHitRounding = 1.0 / 1048576.0; // 2^-20

bool isFinite(vec3 v) { return !(any(isnan(v)) || any(isinf(v))); }

// Adds what is wrong with a hit (ReliefHit in relief_contract.glsl) to gFaults. st is relative to a tile near
// it, so that its rounding is that of the ray's own st and of the way along the map.
void checkHit(ReliefRay ray, ReliefHit hit) {
    if (!hit.hit) return;
    if (!isFinite(vec3(hit.st, hit.t))) {
        gFaults |= kFaultNotFinite;
        return;
    }
    if (hit.t < -kHitRounding || hit.t > 1.0 + kHitRounding) gFaults |= kFaultT;
    vec2 away = abs(hit.st - reliefPosition(ray, hit.t).xy);
    // Not "greater": a place that can't be computed is off the ray.
    if (!all(lessThanEqual(away, kHitRounding * (abs(ray.st) + abs(ray.stTravel))))) gFaults |= kFaultSt;
}

// Normal of P = S - depthWorld * d * normal from its derivatives along s and t; `frame` is that of the base
// at the hit.
vec3 reliefNormal(ReliefFrame frame, vec2 st) {
    vec2 fall = frame.depthWorld * kSeenSide * reliefDepthGradient(st); // of the map, not of its complement
    vec3 positionS = frame.positionS - frame.normal * fall.x;
    vec3 positionT = frame.positionT - frame.normal * fall.y;
    vec3 across = cross(directionOr(positionS, vec3(0.0)), directionOr(positionT, vec3(0.0)));
    if (dot(across, frame.normal) < 0.0) across = -across; // mirrored texture coordinates
    return directionOr(across, frame.normal);
}

// 1 if a second search along the light's ray hits the relief above the point (Watt and Policarpo 2005,
// chapter 5, listing 5.3).
float reliefShadow(ReliefFrame frame, vec3 positionRelief, vec3 toLight) {
    vec3 direction = reliefDirection(frame, -toLight * kSeenSide); // from the polygon inward
    if (direction.z * frame.depthWorld <= kGrazingCosine) return 1.0; // the light is below the tangent plane
    vec2 stEntry = positionRelief.xy - direction.xy * (surfaceT(positionRelief.z) / direction.z);
    ReliefRay ray;
    if (!enterSide(frame, stEntry, direction, ray)) return 0.0;
    ReliefHit hit = traceRelief(ray);
    checkHit(ray, hit);
    return hit.hit && reliefPosition(ray, hit.t).z < positionRelief.z - uShadowBias ? 1.0 : 0.0;
}

// uShadowBias converted to a distance along the light's ray, world units.
float searchMargin(ReliefFrame frame, vec3 toLight) {
    return uShadowBias * frame.depthWorld / max(dot(frame.normal, toLight) * kSeenSide, kSteepestCosine);
}

void main() {
    FragmentHit found;
    if (!traceFragment(found)) discard;
    // From behind, rays enter the relief behind a camera that is within it.
    if (kFromBehind && planarDepth(found.position) <= 0.0) discard;
    checkHit(found.ray, found.hit);
    int iterations = gIterations;

    SurfacePoint point;
    point.position = found.position;
    vec3 normal = reliefNormal(frameAt(found.frame, surfaceRay(found.ray), surfaceT(found.hit.t)), found.hit.st);
    point.normal = normal * kSeenSide;
    point.st = found.hit.st;
    point.back = kFromBehind;
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
    writePoint(point, normal, depth, shadow, vec3(gHeightLookups, gBakedLookups, iterations),
               found.frame.curvature);
}
