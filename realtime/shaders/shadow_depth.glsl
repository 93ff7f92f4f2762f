// Light pass of the shadow maps: the camera is a light, and all that is kept of a fragment is how far along its rays it lies.

void writeLightDistance(vec3 position) {
    float distanceWorld = uEye.w > 0.5 ? length(uEye.xyz - position) : planarDepth(position);
    gl_FragDepth = bufferDepth(distanceWorld);
}
