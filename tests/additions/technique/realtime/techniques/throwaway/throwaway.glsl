ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, reliefDepth(reliefPosition(ray, 0.0).xy)); }
