// The contract between harness, surface and search (README.md says it in words).
//
// Relief space: (s, t, d), texture coordinates and relief depth, d = 0 on top and 1 at the bottom of the relief.

// Below this cosine between a ray and the normal a ray counts as running along the surface: it never gets down into the
// relief, and dividing by its descent would leave float's range. 1e-4 is 0.006 degrees.
const float kGrazingCosine = 1e-4;
// Two tangents are taken as one direction below this squared sine of the angle between them.
const float kSmallestSineSquared = 1e-6;

// A ray's way through the relief, t from 0 at its entry to 1 at the end of the search interval. Made by the surface.
struct ReliefRay {
    vec2 st;           // at t = 0
    vec2 stTravel;     // st at t = 1 minus st at t = 0; between them reliefPosition knows
    float endDepth;    // d at t = 1: 1, or less where the ray ends without having come to the bottom: 0 where it has left the relief again
    float bend;        // where st is linear and d a polynomial in t: d(t) = endDepth t + bend t (1 - t); 0 on a flat base
    float lengthWorld; // from t = 0 to t = 1, world units
    float cosine;      // between the ray and the base's normal at its entry, > 0
    vec2 scaleWorld;   // sx, sy: world units per unit of s and t
    float depthWorld;  // sz: world units per unit of d
    vec4 surfaceA;     // the surface's own, as surfaceB: a search doesn't read them
    vec4 surfaceB;
};

struct ReliefHit {
    bool hit;
    float t;  // where on the ray: decides position and depth
    vec2 st;  // where on the map: decides normal and color
};

// --- given to a search --------------------------------------------------------------------------------------------
vec3 reliefPosition(ReliefRay ray, float t); // (s, t, d)
float descentAt(ReliefRay ray, float t);     // dd/dt
// Largest dd/dt from t on to 1, 0 if d only falls: no step is too long by it. Surfaces that offer bounded_descent have it.
float steepestDescent(ReliefRay ray, float t);
float reliefDepth(vec2 st);                  // the map's depth; one counted look-up
vec4 reliefCell(ivec2 cell);                 // four texels of the map, reliefMapSize(), reliefMapClamps(): height_map.glsl
void countIteration();                       // one more round of the search, for cost.iterations; shadow rays don't count
ReliefHit hitAt(ReliefRay ray, float t) { return ReliefHit(true, t, reliefPosition(ray, t).xy); }
ReliefHit missed() { return ReliefHit(false, 1.0, vec2(0.0)); }

// --- supplied by the search ---------------------------------------------------------------------------------------
ReliefHit traceRelief(ReliefRay ray);

// --- supplied by the surface --------------------------------------------------------------------------------------
// The base under a fragment.
struct ReliefFrame {
    vec3 normal;      // world, unit
    vec3 positionS;   // world, in the tangent plane: change of position per unit of s
    vec3 positionT;
    vec2 st;          // of the fragment
    vec3 curvature;   // A, B, C of the base z = -(A x^2 + C x y + B y^2), x along positionS, y along positionT; world units^-1
    float depthWorld; // relief depth, world units, > 0
};

// sx, sy: world units per unit of s and t.
vec2 reliefScale(ReliefFrame frame) { return vec2(length(frame.positionS), length(frame.positionT)); }

// `direction`: (s, t, d) per world unit of the ray. Returns false where there is nothing to search: the fragment is
// discarded.
bool enterRelief(ReliefFrame frame, vec2 st, vec3 direction, out ReliefRay ray);

// The base at the hit at t. Its positionS and positionT are the derivatives of P = base - depthWorld d normal at constant d, its normal
// the direction depth is measured along.
ReliefFrame frameAt(ReliefFrame frame, ReliefRay ray, float t);
