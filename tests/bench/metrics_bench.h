// What `validate` computes of a pair of frames, and how long it takes.
#pragma once

namespace plumbline {

/// Compares two frames of 1920 x 1080 pixels, a torus and a floor behind it as two techniques might draw
/// them, with every channel; prints medians of wall and CPU time, on all threads and on one.
void printMetrics();

} // namespace plumbline
