// Distance field of the relief on a voxel grid, in units of the relief's depth (realtime/bake/README.md, kind
// distance_field).

// Layers: slices of equal depth; r: from anywhere in the voxel, g: between centers.
uniform sampler2DArray uDistanceField;

ivec3 distanceFieldSize() { return textureSize(uDistanceField, 0); }

// Lower bound on the distance to the relief, valid in the whole voxel of `position` (s, t, d); world units.
float distanceOfVoxel(ReliefRay ray, vec3 position) {
    ++gBakedLookups;
    int slices = textureSize(uDistanceField, 0).z;
    int slice = clamp(int(floor(position.z * float(slices))), 0, slices - 1);
    ivec2 texel = cellOf(position.xy + 0.5 / vec2(reliefMapSize()));
    return texelFetch(uDistanceField, ivec3(texel, slice), 0).r * ray.depthWorld;
}

// Trilinear interpolation between voxel centers, as with hardware filtering. Near the relief it can
// overestimate the distance (TECHNIQUES E11).
float distanceTrilinear(ReliefRay ray, vec3 position) {
    ++gBakedLookups;
    int slices = textureSize(uDistanceField, 0).z;
    float layer = clamp(position.z * float(slices) - 0.5, 0.0, float(slices - 1));
    int upper = min(int(layer), slices - 1), lower = min(upper + 1, slices - 1);
    TexelCorners c = texelCorners(position.xy);
    vec2 between[4];
    between[0] = vec2(texelFetch(uDistanceField, ivec3(c.low, upper), 0).g, texelFetch(uDistanceField, ivec3(c.low, lower), 0).g);
    between[1] = vec2(texelFetch(uDistanceField, ivec3(c.high.x, c.low.y, upper), 0).g,
                      texelFetch(uDistanceField, ivec3(c.high.x, c.low.y, lower), 0).g);
    between[2] = vec2(texelFetch(uDistanceField, ivec3(c.low.x, c.high.y, upper), 0).g,
                      texelFetch(uDistanceField, ivec3(c.low.x, c.high.y, lower), 0).g);
    between[3] = vec2(texelFetch(uDistanceField, ivec3(c.high, upper), 0).g, texelFetch(uDistanceField, ivec3(c.high, lower), 0).g);
    vec2 both = mix(mix(between[0], between[1], c.weight.x), mix(between[2], between[3], c.weight.x), c.weight.y);
    return mix(both.x, both.y, layer - float(upper)) * ray.depthWorld;
}
