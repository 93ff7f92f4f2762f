// Vertex shader of the polygon proxy.

layout(location = 0) in vec3 inPosition; // relative
layout(location = 1) in vec3 inNormal;   // world, unit
layout(location = 2) in vec3 inPositionS; // dS/ds, world units per unit of s
layout(location = 3) in vec3 inPositionT;
layout(location = 4) in vec2 inSt;
layout(location = 5) in vec3 inCurvature; // quadric coefficients A, B, cross term
layout(location = 6) in vec4 inTriangleStAB; // st of the triangle's corners, the same at all three
layout(location = 7) in vec2 inTriangleStC;

uniform mat4 uClipFromRelative;

out vec3 vPosition;
out vec3 vNormal;
out vec3 vPositionS;
out vec3 vPositionT;
out vec2 vSt;
out vec3 vCurvature;
flat out vec4 vTriangleStAB;
flat out vec2 vTriangleStC;

void main() {
    vPosition = inPosition;
    vNormal = inNormal;
    vPositionS = inPositionS;
    vPositionT = inPositionT;
    vSt = inSt;
    vCurvature = inCurvature;
    vTriangleStAB = inTriangleStAB;
    vTriangleStC = inTriangleStC;
    gl_Position = uClipFromRelative * vec4(inPosition, 1.0);
}
