// Fragment shader of the pass that finds which side of the reliefs' polygons is nearest in each pixel.

in vec3 vPosition;

void main() { gl_FragDepth = bufferDepth(planarDepth(vPosition)); }
