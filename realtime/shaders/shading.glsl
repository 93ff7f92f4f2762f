// Writes the channels of a surface point, with the shading formula (C++ version: kAmbient in
// scenes/scene/scene.h).

layout(location = 0) out vec4 outColor;    // linear R G B; iterations
layout(location = 1) out vec4 outPosition; // position (relative), planar depth Z
layout(location = 2) out vec4 outNormal;   // unit normal, world; lookups of the height map
layout(location = 3) out vec4 outTexture;  // s, t; id, 0 where nothing is drawn; lookups of baked maps
layout(location = 4) out vec4 outSurface;  // flags (below); curvature

uniform vec3 uColor;
uniform bool uHasColorMap;
uniform sampler2D uColorMap; // linear RGB, row 0 = bottom
uniform float uObjectId;     // object index + 1

// Flags as an integer: bit i is the shadow of light i; then, above the most lights there may be, one for the
// back side, and gFaults.
const float kBackFlag = 65536.0, kFaultFlags = 131072.0; // 2^16, 2^17

// What the harness found wrong with this pixel's hits, of the view ray and of shadow rays: the values of the
// channel `fault`.
const int kFaultNotFinite = 1, kFaultT = 2, kFaultSt = 4;
int gFaults = 0;

const float kAmbient = 0.05;

struct SurfacePoint {
    vec3 position; // relative
    vec3 normal;   // world, unit; of the side that is seen
    vec2 st;
    bool back;     // the inner side is seen
};

// Unit vector from a point toward light `i`, which is given as (direction, 0) or (position, 1).
vec3 directionToLight(int i, vec3 position) {
    vec4 light = uLights[i];
    return light.w > 0.5 ? directionOr(light.xyz - position, vec3(0.0)) : light.xyz;
}

// Exact bilinear lookup with repeat, like ColorMap::sample.
vec3 colorAt(vec2 st) {
    if (!uHasColorMap) return uColor;
    ivec2 size = textureSize(uColorMap, 0);
    vec2 texels = (st - floor(st)) * vec2(size) - 0.5;
    vec2 weight = texels - floor(texels);
    ivec2 low = ivec2(floor(texels));
    ivec2 high = low + 1;
    if (low.x < 0) low.x += size.x;
    if (low.y < 0) low.y += size.y;
    if (high.x >= size.x) high.x -= size.x;
    if (high.y >= size.y) high.y -= size.y;
    vec3 lower = mix(texelFetch(uColorMap, low, 0).rgb, texelFetch(uColorMap, ivec2(high.x, low.y), 0).rgb, weight.x);
    vec3 upper = mix(texelFetch(uColorMap, ivec2(low.x, high.y), 0).rgb, texelFetch(uColorMap, high, 0).rgb, weight.x);
    return mix(lower, upper, weight.y);
}

// `normal`: outward. `depth`: planar depth Z. `shadow`: 1 in shadow, 0 lit, one per light. `cost`: lookups of the height map,
// lookups of baked maps, iterations. `curvature`: of the base, A, B and the cross term.
void writePoint(SurfacePoint point, vec3 normal, float depth, float shadow[kLightSlots], vec3 cost, vec3 curvature) {
    float light = kAmbient, flags = (point.back ? kBackFlag : 0.0) + float(gFaults) * kFaultFlags, bit = 1.0;
    for (int i = 0; i < kLightCount; ++i) {
        light += max(dot(point.normal, directionToLight(i, point.position)), 0.0) * (1.0 - shadow[i]);
        flags += bit * shadow[i];
        bit *= 2.0;
    }
    outColor = vec4(colorAt(point.st) * light, cost.z);
    outPosition = vec4(point.position, depth);
    outNormal = vec4(normal, cost.x);
    outTexture = vec4(point.st, uObjectId, cost.y);
    outSurface = vec4(flags, curvature);
    gl_FragDepth = bufferDepth(depth);
}
