// Parallax mapping: the relief is taken to be as deep everywhere as below the fragment.
//
// On a flat base d = t. In the sources the displacement is SCALE texel + BIAS along the normal, with any BIAS; relief and this
// project's reference put the top of the map at the polygon. With heights that is BIAS = -SCALE (E10 of the project's errata),
// with depths bias 0, the default. Chapter 5's L5.1 has its polygon half way down: bias = -0.5. Its "height" is a depth, which goes
// along the ray from the eye (E30).

ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, scale * reliefDepth(ray.st) + bias); }
