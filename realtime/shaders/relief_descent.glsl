// The bound on the descent, on surfaces that offer bounded_descent. From behind it is that of the whole ray,
// because the surface's is for what lies between a place and the bottom, the part already passed.

float steepestDescent(ReliefRay ray, float t) { return surfaceSteepestDescent(surfaceRay(ray), kFromBehind ? 0.0 : t); }
