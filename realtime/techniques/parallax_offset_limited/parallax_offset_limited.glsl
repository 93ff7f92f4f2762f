// Parallax mapping with offset limiting: the division by the ray's descent is omitted, so that the offset on
// the map is d0 sz (V.T / sx, V.B / sy) for a unit ray V, proportional to the sine of its angle instead of
// the tangent.
//
// Premecz, section 2.2, describes it as a limit, but it differs from plain parallax mapping at all angles: at
// 45 degrees the offset is 0.707 of it (E9 of the project's errata; this is his code and that of Watt and
// Policarpo, chapter 5, L5.1). On the ray, whose length to depth 1 is sz / cosine on a flat base, that is t =
// d0 cosine.
//
// scale and bias: parallax/parallax.glsl.

ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, (scale * reliefDepth(ray.st) + bias) * ray.cosine); }
