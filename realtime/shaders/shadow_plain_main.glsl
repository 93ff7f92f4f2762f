// Fragment shader of the light pass for an object without relief.

in vec3 vPosition;

void main() { writeLightDistance(vPosition); }
