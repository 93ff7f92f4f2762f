// Shadow map lookup by receivers. shadow_projection.h defines the maps and the positions of their texels.

// Distances along the light's rays, mapped to [0, 1] over its range.
uniform sampler2DArray uShadowMaps;
// Directional lights: (u, v) on the map in [0,1], distance in world units.
uniform mat4 uShadowPlaceFromRelative[kLightSlots];
// First layer; minimum distance; 1 / (maximum - minimum); half a texel's diagonal, world units (for a point
// light, at distance 1 along the axis of the cube's face).
uniform vec4 uShadowMap[kLightSlots];
uniform float uShadowRounding[kLightSlots]; // bound on the rounding error of a distance, world units
uniform float uShadowMapBias;               // factor of the derived bias

// N.L below which the bias doesn't grow further: such a light contributes less to a point than the ambient
// light, kAmbient.
const float kSteepestCosine = 0.05;

struct ShadowPlace {
    vec2 place;         // on the map, in [0,1] if inside
    float layer;
    float distanceWorld; // along the light's rays
    float halfDiagonal; // of a texel, perpendicular to the light's rays, world units
};

ShadowPlace directionalPlace(int i, vec3 position) {
    vec3 place = (uShadowPlaceFromRelative[i] * vec4(position, 1.0)).xyz;
    return ShadowPlace(place.xy, uShadowMap[i].x, place.z, uShadowMap[i].w);
}

// The position on the light's cube map. The face (+x, -x, +y, -y, +z, -z) is that of the direction's largest
// component.
ShadowPlace pointPlace(int i, vec3 position) {
    vec3 d = position - uLights[i].xyz, size = abs(d);
    // Position in [-1,1], positive face of the axis, component along the axis.
    vec4 face = vec4(-d.y / d.x, d.z / size.x, 0.0, d.x);
    if (size.y > size.x && size.y >= size.z) face = vec4(-d.z / d.y, d.x / size.y, 2.0, d.y);
    if (size.z > size.x && size.z > size.y) face = vec4(-d.x / d.z, d.y / size.z, 4.0, d.z);
    float layer = uShadowMap[i].x + face.z + (face.w < 0.0 ? 1.0 : 0.0);
    return ShadowPlace(clamp(0.5 * face.xy + 0.5, 0.0, 1.0), layer, length(d), abs(face.w) * uShadowMap[i].w);
}

// 1 if the map of light `i` has an occluder nearer to the light than the point; 0 outside the map. Uses a
// single unfiltered lookup. README.md derives the bias. `marginWorld`: error bound of the technique's hits
// along the light's ray.
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
    // An empty texel stores 1, and a hit beyond the range stores kFarthestHit (bufferDepth). Neither may cast
    // a shadow, because its distance is unknown.
    float reach = min((at.distanceWorld - bias - uShadowMap[i].y) * uShadowMap[i].z, kFarthestHit);
    return stored < reach ? 1.0 : 0.0;
}
