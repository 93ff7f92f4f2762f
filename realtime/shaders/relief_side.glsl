// The relief as a search sees it, from the side of the surface that is drawn.
//
// From behind, a ray enters the layer at the bottom of the relief and leaves it through the polygon. The
// surface describes that line from the polygon inward, as it does for the front. Here it is followed the
// other way, with all depths counted from the bottom:
//     t = 1 - t of the surface,  d = 1 - d of the surface,  D = 1 - D of the map,
// the last one because the complement of the map, and what was baked of it, is bound (draw/back_sides.h). A
// search then finds where the ray first leaves the material, by the same steps by which it finds from the
// front where the ray first enters it.

// Between a ray as a search sees it and as the surface describes it: the same function in both directions.
// endDepth is 1 on either; from behind, d = endDepth t + bend t (1 - t) only changes the sign of bend.
ReliefRay surfaceRay(ReliefRay ray) {
    if (kFromBehind) {
        ray.st += ray.stTravel;
        ray.stTravel = -ray.stTravel;
        ray.bend = -ray.bend;
    }
    return ray;
}

float surfaceT(float t) { return kFromBehind ? 1.0 - t : t; }

float polygonT() { return surfaceT(0.0); }

// `direction`: along the ray from the front, against it from behind, so that it descends from the polygon.
// Returns false if the fragment must be discarded. From behind that includes rays that don't come from the
// bottom of the relief: they entered it through its outer side, which a front face shows.
bool enterSide(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray) {
    bool enters = enterRelief(frame, st, direction, ray);
    if (kFromBehind) enters = enters && ray.endDepth >= 1.0;
    ray = surfaceRay(ray);
    return enters;
}

vec3 reliefPosition(ReliefRay ray, float t) {
    vec3 position = surfacePosition(surfaceRay(ray), surfaceT(t));
    if (kFromBehind) position.z = 1.0 - position.z;
    return position;
}

float descentAt(ReliefRay ray, float t) { return surfaceDescent(surfaceRay(ray), surfaceT(t)); }
