// The hit of the ray through a fragment, from the camera or, in the light pass of shadow maps, from a light.

flat in vec4 vTriangleStAB;
flat in vec2 vTriangleStC;

struct FragmentHit {
    ReliefFrame frame;
    ReliefRay ray; // as the search sees it
    ReliefHit hit;
    vec3 position; // of the hit, relative
};

float doubledArea(vec2 a, vec2 b, vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// Whether st is inside the drawn triangle (Premecz 2006, section 1.1). Always true for a triangle without
// area in st.
bool insideTriangle(vec2 st) {
    vec2 a = vTriangleStAB.xy, b = vTriangleStAB.zw, c = vTriangleStC;
    float whole = doubledArea(a, b, c);
    return doubledArea(a, b, st) * whole >= 0.0 && doubledArea(b, c, st) * whole >= 0.0 &&
           doubledArea(c, a, st) * whole >= 0.0;
}

// Returns false if the fragment must be discarded.
bool traceFragment(out FragmentHit found) {
    vec3 inward = directionToCamera(vPosition) * (kFromBehind ? 1.0 : -1.0);
    found.frame = fragmentFrame();
    found.hit = missed();
    found.position = vPosition;
    if (!enterSide(found.frame, found.frame.st, reliefDirection(found.frame, inward), found.ray)) return false;
    found.hit = traceRelief(found.ray);
    found.position = vPosition + inward * (surfaceT(found.hit.t) * found.ray.lengthWorld);
    return found.hit.hit && !(kTriangleBounds && !insideTriangle(found.hit.st));
}
