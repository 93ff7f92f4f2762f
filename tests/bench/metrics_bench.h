// What `validate` computes of a pair of frames, and how long it takes.
#pragma once

namespace plumbline {

/// Compares two frames of 1920 x 1080 pixels, a torus and a floor behind it as two techniques might draw them, with every channel;
/// prints the median, and that of one thread.
void printMetrics();

} // namespace plumbline
