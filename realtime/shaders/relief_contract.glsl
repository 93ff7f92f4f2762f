// The interface between harness, surface and search (described in README.md).
//
// Relief space: (s, t, d), texture coordinates and relief depth, d = 0 on top and 1 at the bottom of the
// relief.

// Rays with a smaller cosine to the normal count as parallel to the surface: they don't descend into the
// relief, and dividing by their descent would overflow. 1e-4 is 0.006 degrees.
const float kGrazingCosine = 1e-4;
// Two tangents count as parallel below this squared sine of the angle between them.
const float kSmallestSineSquared = 1e-6;

// A ray through the relief, with t from 0 at its entry to 1 at the end of the search interval. Created by the
// surface.
struct ReliefRay {
    vec2 st;           // at t = 0
    vec2 stTravel;     // st at t = 1 minus st at t = 0; in between use reliefPosition
    // d at t = 1: 1 at the bottom of the relief, less if the ray ends above it, 0 if it leaves the relief
    // through the top
    float endDepth;
    // If st is linear and d is a polynomial in t: d(t) = endDepth t + bend t (1 - t); 0 on a flat base.
    float bend;
    float lengthWorld; // from t = 0 to t = 1, world units
    float cosine;      // between the ray and the base's normal at the entry, >= 0
    vec2 scaleWorld;   // sx, sy: world units per unit of s and t
    float depthWorld;  // sz: world units per unit of d
    vec4 surfaceA;     // private to the surface, like surfaceB; not read by a search
    vec4 surfaceB;
};

// What a hit must keep to: t is in [0, 1] and st is the ray's there, both within rounding (checkHit in
// relief_main.glsl). A hit that doesn't is drawn as it is, and its pixel is marked and counted.
struct ReliefHit {
    bool hit; // false: the other two are ignored
    float t;  // on the ray: determines position and depth
    vec2 st;  // on the map: determines normal and color
};

// --- available to a search -----------------------------------------------------------------------
// From behind, rays enter at the bottom of the relief, and all depths are counted from there: relief_side.glsl.
vec3 reliefPosition(ReliefRay ray, float t); // (s, t, d)
float descentAt(ReliefRay ray, float t);     // dd/dt
// Upper bound of dd/dt on [t, 1], 0 if d only decreases, for conservative steps. Only on surfaces that offer
// bounded_descent.
float steepestDescent(ReliefRay ray, float t);
float reliefDepth(vec2 st);                  // the map's depth; counts one lookup
// Four texels of the map, reliefMapSize(), reliefMapClamps(): height_map.glsl.
vec4 reliefCell(ivec2 cell);
// One iteration of the search, for cost.iterations; not counted for shadow rays.
void countIteration();
ReliefHit hitAt(ReliefRay ray, float t) { return ReliefHit(true, t, reliefPosition(ray, t).xy); }
float polygonT(); // t of the polygon that is drawn: 0, from behind 1
ReliefHit missed() { return ReliefHit(false, 1.0, vec2(0.0)); }

// --- provided by the search ----------------------------------------------------------------------
ReliefHit traceRelief(ReliefRay ray);

// --- provided by the surface ---------------------------------------------------------------------
// The base under a fragment.
struct ReliefFrame {
    vec3 normal;      // world, unit
    vec3 positionS;   // world, in the tangent plane: change of position per unit of s
    vec3 positionT;
    vec2 st;          // of the fragment
    // A, B, C of the base z = -(A x^2 + C x y + B y^2), x along positionS, y along positionT; world
    // units^-1.
    vec3 curvature;
    float depthWorld; // relief depth, world units, > 0
};

// sx, sy: world units per unit of s and t.
vec2 reliefScale(ReliefFrame frame) { return vec2(length(frame.positionS), length(frame.positionT)); }

// `direction`: (s, t, d) per world unit of the ray. Returns false if there is nothing to search; the fragment
// is then discarded.
bool enterRelief(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray);

// The ray's way and its descent, without regard to the side that is drawn: t from 0 at the polygon to 1 at the
// bottom of the relief or the end of the ray.
vec3 surfacePosition(ReliefRay ray, float t); // (s, t, d)
float surfaceDescent(ReliefRay ray, float t); // dd/dt
// Upper bound of dd/dt on [t, 1]; only if the surface offers bounded_descent.
float surfaceSteepestDescent(ReliefRay ray, float t);

// The frame of the base at the hit at t of the surface. positionS and positionT are the derivatives of P = base - depthWorld
// d normal at constant d; normal is the direction along which depth is measured.
ReliefFrame frameAt(ReliefFrame frame, ReliefRay ray, float t);
