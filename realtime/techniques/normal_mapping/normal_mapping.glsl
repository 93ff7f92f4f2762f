// The polygon with the relief's normals: nothing moves.

ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, 0.0); }
