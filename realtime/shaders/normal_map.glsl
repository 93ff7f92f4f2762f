// The relief's normal and depth in one look-up (realtime/bake/README.md, kind normal).

uniform sampler2DArray uNormalMap; // rgb: unit normal along s, along t, outward, at the scale below; a: relief depth
uniform vec3 uNormalMapScale;      // sx, sy, sz it was made at

vec4 normalMapTexel(ivec2 texel) { return texelFetch(uNormalMap, ivec3(texel, 0), 0); }

// xyz: the unit normal (along s, along t, outward) at the ray's own mapping scale; w: relief depth. Bilinear. A stored normal
// belongs to one scale and is wrong at any other (TECHNIQUES E7): its slope is taken back to map units and out again.
vec4 normalAndDepth(ReliefRay ray, vec2 st) {
    ++gBakedLookups;
    TexelCorners c = texelCorners(st);
    vec4 texel = mix(mix(normalMapTexel(c.low), normalMapTexel(ivec2(c.high.x, c.low.y)), c.weight.x),
                     mix(normalMapTexel(ivec2(c.low.x, c.high.y)), normalMapTexel(c.high), c.weight.x), c.weight.y);
    vec2 slope = texel.xy / texel.z * (uNormalMapScale.xy / uNormalMapScale.z); // depth per map width and height
    vec2 scale = max(ray.scaleWorld, vec2(1e-30)); // where st has no extent the normal lies flat, not undefined
    return vec4(normalize(vec3(slope * (ray.depthWorld / scale), 1.0)), texel.w);
}
