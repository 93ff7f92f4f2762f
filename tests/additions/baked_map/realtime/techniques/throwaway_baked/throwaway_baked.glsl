ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, throwawayDepth(reliefPosition(ray, 0.0).xy)); }
