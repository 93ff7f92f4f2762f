// Baked maps: time to bake each kind, and the speedup over the definition to which it is exactly equal.
#pragma once

namespace plumbline {

/// Bakes every kind of cone map from the generated height maps at increasing sizes, and the distance field if
/// there is one; prints medians. Sizes are skipped if the smaller one took too long.
void printBakes();

} // namespace plumbline
