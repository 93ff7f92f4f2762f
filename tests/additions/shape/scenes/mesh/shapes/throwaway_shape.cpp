#include "scenes/mesh/shapes/throwaway_shape.h"

#include "scenes/mesh/shapes/shapes.h"

namespace plumbline {

ControlMesh makeThrowawayShape(double depth) {
    return makePlane(2 * depth, depth, 2, 1);
}

} // namespace plumbline
