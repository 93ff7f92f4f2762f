// Parallax mapping with offset limiting: the division by the ray's descent is left out, so that the offset on the map is
// d0 sz (V.T / sx, V.B / sy) for a unit ray V, as long as the sine of its angle instead of the tangent.
//
// The text of Premecz, section 2.2, speaks of a limit where it differs from plain parallax at once: at 45 degrees it goes 0.707 of the
// way (E9 of the project's errata; his code and that of Watt and Policarpo, chapter 5, L5.1, is what is here). On the ray, whose
// length to depth 1 is sz / cosine on a flat base, that is t = d0 cosine.
//
// scale and bias: parallax/parallax.glsl.

ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, (scale * reliefDepth(ray.st) + bias) * ray.cosine); }
