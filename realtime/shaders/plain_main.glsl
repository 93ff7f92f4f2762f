// Fragment shader of an object without relief.

in vec3 vPosition;
in vec3 vNormal;
in vec2 vSt;

void main() {
    vec3 toCamera = directionToCamera(vPosition);
    vec3 normal = directionOr(vNormal, toCamera);
    // Shading and shadows are of the side that is seen, as in the reference.
    SurfacePoint point = SurfacePoint(vPosition, gl_FrontFacing ? normal : -normal, vSt, !gl_FrontFacing);
    float shadow[kLightSlots];
    for (int i = 0; i < kLightCount; ++i) {
        vec3 toLight = directionToLight(i, vPosition);
        shadow[i] = dot(point.normal, toLight) <= 0.0 ? 1.0 : 0.0;
        if (kShadowMaps && shadow[i] == 0.0) shadow[i] = mapShadow(i, vPosition, point.normal, toLight, 0.0);
    }
    writePoint(point, normal, planarDepth(vPosition), shadow, vec3(0.0), vec3(0.0));
}
