// What the harness adds to a search: the same search in it and in a bare shader.
#pragma once

namespace plumbline {

/// Prints a row a technique, on stone_torus at 800 x 600. Says why, if there is no OpenGL.
void printHarness();

/// Prints what each surface costs under one search: Eq. 6 of RP-351 against Eq. 7 and the others.
void printSurfaces();

} // namespace plumbline
