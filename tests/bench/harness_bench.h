// The overhead of the harness: the same search in it and in a bare shader.
#pragma once

namespace plumbline {

/// Prints a row for each technique, on stone_torus at 800 x 600, or the reason if there is no OpenGL.
void printHarness();

/// Prints the cost of each surface with the same search: Eq. 6 of RP-351, Eq. 7 and the others.
void printSurfaces();

} // namespace plumbline
