// The base under the fragment, and the transformation of rays to its relief space.

in vec3 vPosition;
in vec3 vNormal;
in vec3 vPositionS;
in vec3 vPositionT;
in vec2 vSt;
in vec3 vCurvature;

uniform float uReliefDepthWorld;

ReliefFrame fragmentFrame() {
    ReliefFrame frame;
    frame.normal = directionOr(vNormal, directionToCamera(vPosition) * (kFromBehind ? -1.0 : 1.0));
    frame.positionS = vPositionS - frame.normal * dot(frame.normal, vPositionS);
    frame.positionT = vPositionT - frame.normal * dot(frame.normal, vPositionT);
    frame.st = vSt;
    frame.curvature = vCurvature;
    frame.depthWorld = uReliefDepthWorld;
    return frame;
}

// (v_s, v_t, v_d): a world direction in relief space, per world unit. The inverse Gram matrix handles
// tangents that aren't orthogonal (Premecz, section 1.1); it is applied to unit vectors so that no product
// overflows. Where the texture coordinates are singular (a pole), the ray goes straight down.
vec3 reliefDirection(ReliefFrame frame, vec3 direction) {
    float descent = -dot(direction, frame.normal) / frame.depthWorld;
    float scaleS = length(frame.positionS), scaleT = length(frame.positionT);
    if (!(scaleS > 0.0 && scaleT > 0.0)) return vec3(0.0, 0.0, descent);
    vec3 tangentS = frame.positionS / scaleS, tangentT = frame.positionT / scaleT;
    float cosine = dot(tangentS, tangentT);
    float sineSquared = 1.0 - cosine * cosine;
    if (!(sineSquared > kSmallestSineSquared)) return vec3(0.0, 0.0, descent);
    float alongS = dot(direction, tangentS), alongT = dot(direction, tangentT);
    return vec3((alongS - cosine * alongT) / (sineSquared * scaleS), (alongT - cosine * alongS) / (sineSquared * scaleT),
                descent);
}
