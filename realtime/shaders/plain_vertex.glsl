// Vertex shader of an object drawn without relief: a proxy or micro-triangles.

layout(location = 0) in vec3 inPosition; // relative
layout(location = 1) in vec3 inNormal;   // world, unit
layout(location = 4) in vec2 inSt;

uniform mat4 uClipFromRelative;

out vec3 vPosition;
out vec3 vNormal;
out vec2 vSt;

void main() {
    vPosition = inPosition;
    vNormal = inNormal;
    vSt = inSt;
    gl_Position = uClipFromRelative * vec4(inPosition, 1.0);
}
