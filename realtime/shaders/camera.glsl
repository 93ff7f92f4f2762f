// Camera and lights, the same for every object.
//
// Positions are relative to the renderer's origin, a point near the scene and the camera: float holds them well whether
// the scene is measured in millimeters or kilometers. The harness adds the origin back in double precision.

uniform vec4 uEye;        // perspective: position, w = 1; orthographic: unit direction toward the camera, w = 0
uniform vec4 uDepthPlane; // planar depth Z = dot(xyz, position) + w, world units
uniform vec2 uDepthRange; // lowest Z of the scene, 1 / (highest - lowest)

vec3 directionOr(vec3 v, vec3 fallback) {
    float lengthSquared = dot(v, v);
    return lengthSquared > 0.0 ? v * inversesqrt(lengthSquared) : fallback;
}

// Unit vector from a point toward the camera.
vec3 directionToCamera(vec3 position) {
    return uEye.w > 0.5 ? directionOr(uEye.xyz - position, uDepthPlane.xyz * -1.0) : uEye.xyz;
}

// The largest float below 1, the depth of the background: a hit beyond the scene's depth, as grazing rays on a flat base can
// have, is a hit.
const float kFarthestHit = 0.99999994;

// Linear over the scene's range.
float bufferDepth(float depth) { return clamp((depth - uDepthRange.x) * uDepthRange.y, 0.0, kFarthestHit); }

float planarDepth(vec3 position) { return dot(uDepthPlane.xyz, position) + uDepthPlane.w; }
