// Shadow maps as receivers read them. shadow_projection.h says what a light's map is and where its texels lie.

uniform sampler2DArray uShadowMaps;                   // distances along the light's rays, 0 to 1 over its range
uniform mat4 uShadowPlaceFromRelative[kLightSlots];   // directional: (u, v) on the map in [0,1], distance in world units
uniform vec4 uShadowMap[kLightSlots]; // first layer; nearest distance; 1 / (farthest - nearest); half a texel's diagonal, world
                                      // units (point: at distance 1 along the axis of the cube's face)
uniform float uShadowRounding[kLightSlots]; // what float may lose of a distance, world units
uniform float uShadowMapBias;               // times the bias derived

// N.L below which the bias grows no more: what such a light adds to a point is less than the ambient light's share, kAmbient.
const float kSteepestCosine = 0.05;

struct ShadowPlace {
    vec2 place;         // on the map, [0,1] inside
    float layer;
    float distanceWorld; // along the light's rays
    float halfDiagonal; // of a texel, across the light's rays, world units
};

ShadowPlace directionalPlace(int i, vec3 position) {
    vec3 place = (uShadowPlaceFromRelative[i] * vec4(position, 1.0)).xyz;
    return ShadowPlace(place.xy, uShadowMap[i].x, place.z, uShadowMap[i].w);
}

// The face of the light's cube, +x -x +y -y +z -z, on which a direction ends: the axis it is longest along.
ShadowPlace pointPlace(int i, vec3 position) {
    vec3 d = position - uLights[i].xyz, size = abs(d);
    vec4 face = vec4(-d.y / d.x, d.z / size.x, 0.0, d.x); // place in [-1,1], face of the positive side, along the axis
    if (size.y > size.x && size.y >= size.z) face = vec4(-d.z / d.y, d.x / size.y, 2.0, d.y);
    if (size.z > size.x && size.z > size.y) face = vec4(-d.x / d.z, d.y / size.z, 4.0, d.z);
    float layer = uShadowMap[i].x + face.z + (face.w < 0.0 ? 1.0 : 0.0);
    return ShadowPlace(clamp(0.5 * face.xy + 0.5, 0.0, 1.0), layer, length(d), abs(face.w) * uShadowMap[i].w);
}

// 1 where the map of light `i` has something nearer to the light than the point; 0 outside of the map. One look-up, compared
// as it is. README.md derives the bias. `marginWorld`: what the technique itself may be off, along the light's ray.
float mapShadow(int i, vec3 position, vec3 normal, vec3 toLight, float marginWorld) {
    ShadowPlace at = directionalPlace(i, position);
    if (uLights[i].w > 0.5) at = pointPlace(i, position);
    if (any(lessThan(at.place, vec2(0.0))) || any(greaterThan(at.place, vec2(1.0)))) return 0.0;
    int size = textureSize(uShadowMaps, 0).x;
    ivec2 texel = min(ivec2(at.place * float(size)), ivec2(size - 1));
    float stored = texelFetch(uShadowMaps, ivec3(texel, int(at.layer)), 0).r;
    float cosine = clamp(dot(normal, toLight), kSteepestCosine, 1.0);
    float tangent = sqrt(1.0 - cosine * cosine) / cosine;
    float bias = uShadowMapBias * (at.halfDiagonal * (1.0 + tangent) + uShadowRounding[i]) + marginWorld;
    // An empty texel holds 1, a hit beyond the range kFarthestHit (bufferDepth): neither is known to be nearer than anything.
    float reach = min((at.distanceWorld - bias - uShadowMap[i].y) * uShadowMap[i].z, kFarthestHit);
    return stored < reach ? 1.0 : 0.0;
}
