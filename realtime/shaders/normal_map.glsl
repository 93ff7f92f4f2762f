// The relief's normal and depth in one lookup (realtime/bake/README.md, kind normal).

// rgb: unit normal along s, along t, outward, at the scale below; a: relief depth.
uniform sampler2DArray uNormalMap;
uniform vec3 uNormalMapScale;      // sx, sy, sz for which it was baked

vec4 normalMapTexel(ivec2 texel) { return texelFetch(uNormalMap, ivec3(texel, 0), 0); }

// xyz: the unit normal (along s, along t, outward) at the ray's mapping scale; w: relief depth. Bilinear. A
// stored normal is only valid for the scale for which it was baked (TECHNIQUES E7), so its slope is converted
// to map units and then to the ray's scale.
vec4 normalAndDepth(ReliefRay ray, vec2 st) {
    ++gBakedLookups;
    TexelCorners c = texelCorners(st);
    vec4 texel = mix(mix(normalMapTexel(c.low), normalMapTexel(ivec2(c.high.x, c.low.y)), c.weight.x),
                     mix(normalMapTexel(ivec2(c.low.x, c.high.y)), normalMapTexel(c.high), c.weight.x), c.weight.y);
    // Depth per map width and height.
    vec2 slope = texel.xy / texel.z * (uNormalMapScale.xy / uNormalMapScale.z);
    vec2 scale = max(ray.scaleWorld, vec2(1e-30)); // where st is singular, the normal is the base's, not NaN
    return vec4(normalize(vec3(slope * (ray.depthWorld / scale), 1.0)), texel.w);
}
