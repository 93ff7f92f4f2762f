// Fragment shader of the light pass for a relief, which traces the light's ray with the technique.

void main() {
    FragmentHit found;
    if (!traceFragment(found)) discard;
    writeLightDistance(found.position);
}
