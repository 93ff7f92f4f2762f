// Uniforms of the camera, shared by all objects.
//
// Positions are relative to the renderer's origin, a point near the scene and the camera, so that single
// precision is sufficient at any scale and distance from the world origin. The harness adds the origin in
// double precision.

// Perspective: position, w = 1; orthographic: unit direction toward the camera, w = 0.
uniform vec4 uEye;
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

// The largest float below 1, which is the background's depth. Hits beyond the scene's depth range, which
// grazing rays on a flat base can have, are clamped to it so that they remain distinguishable from the
// background.
const float kFarthestHit = 0.99999994;

// Linear over the scene's range.
float bufferDepth(float depth) { return clamp((depth - uDepthRange.x) * uDepthRange.y, 0.0, kFarthestHit); }

float planarDepth(vec3 position) { return dot(uDepthPlane.xyz, position) + uDepthPlane.w; }
