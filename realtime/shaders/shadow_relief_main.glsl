// A relief in the light pass: the technique's own hit of the light's ray.

void main() {
    FragmentHit found;
    if (!traceFragment(found)) discard;
    writeLightDistance(found.position);
}
