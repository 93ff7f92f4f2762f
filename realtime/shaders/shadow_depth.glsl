// Light pass of the shadow maps: the camera is a light, and only the distance along the light's ray is
// written.

void writeLightDistance(vec3 position) {
    float distanceWorld = uEye.w > 0.5 ? length(uEye.xyz - position) : planarDepth(position);
    gl_FragDepth = bufferDepth(distanceWorld);
}
