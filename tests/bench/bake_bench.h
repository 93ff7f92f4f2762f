// Baked maps: how long each kind takes, and what it saves of the definition it is exactly equal to.
#pragma once

namespace plumbline {

/// Bakes every kind of cone map from the generated height maps at growing sizes, and the distance field where
/// there is one; prints medians. Sizes whose smaller one took long are left out.
void printBakes();

} // namespace plumbline
