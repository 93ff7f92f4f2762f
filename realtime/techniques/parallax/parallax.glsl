// Parallax mapping: assumes that the relief has the same depth everywhere as below the fragment.
//
// On a flat base d = t. In the sources the displacement is SCALE texel + BIAS along the normal, with any
// BIAS. In relief mapping and in this project's reference, the top of the map is at the polygon. For heights
// that is BIAS = -SCALE (E10 of the project's errata), for depths bias 0, the default. In chapter 5's L5.1
// the polygon is in the middle of the layer: bias = -0.5. Its "height" is a depth, measured along the ray
// from the eye (E30).

ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, scale * reliefDepth(ray.st) + bias); }
