// Where faces displace a point that they share differently (Relief::seams), welding displaces it by the mean
// of the sides: of the groups of faces that agree, whatever their number of faces. Otherwise a seam's
// vertices would be displaced unlike its edges, which have one face on either side.
#pragma once

#include "scenes/core/math.h"

#include <vector>

namespace plumbline {

/// Displacements that differ by less than this fraction of the relief's depth count as equal: it is one step
/// of an 8-bit map, so the difference may be quantization. Likewise directions, which then move a point by
/// less than this fraction of its displacement.
inline constexpr double kTornFraction = 1.0 / 256;

/// One face's displacement of a point.
struct Displacement {
    Vec3 direction; // unit
    double height;  // along it, world units
};

/// One displacement for each group of faces that agree, the mean of theirs; those of all faces unchanged if
/// all agree. `depth`: of the relief. The groups don't depend on the order of the faces.
std::vector<Displacement> weldedSides(std::vector<Displacement> ofFaces, double depth);

} // namespace plumbline
