// An object drawn as it is, in the light pass.

in vec3 vPosition;

void main() { writeLightDistance(vPosition); }
