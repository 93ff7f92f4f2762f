// Fragment shader of an object without relief.

in vec3 vPosition;
in vec3 vNormal;
in vec2 vSt;

// Both sides are visible, as in the reference: shading and shadows use the side that faces the camera.
uniform bool uTwoSided;

void main() {
    vec3 toCamera = directionToCamera(vPosition);
    vec3 normal = directionOr(vNormal, toCamera);
    bool away = uTwoSided && !gl_FrontFacing;
    SurfacePoint point = SurfacePoint(vPosition, away ? -normal : normal, vSt);
    float shadow[kLightSlots];
    for (int i = 0; i < kLightCount; ++i) {
        vec3 toLight = directionToLight(i, vPosition);
        shadow[i] = dot(point.normal, toLight) <= 0.0 ? 1.0 : 0.0;
        if (kShadowMaps && shadow[i] == 0.0) shadow[i] = mapShadow(i, vPosition, point.normal, toLight, 0.0);
    }
    writePoint(point, normal, planarDepth(vPosition), shadow, vec3(0.0), vec3(0.0));
}
