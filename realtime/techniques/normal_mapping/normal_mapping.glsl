// The polygon with the relief's normals, without displacement.

ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, polygonT()); }
