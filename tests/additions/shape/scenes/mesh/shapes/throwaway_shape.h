// Throw-away: a plane that is twice as wide as deep.
#pragma once

#include "scenes/mesh/control_mesh.h"

namespace plumbline {

ControlMesh makeThrowawayShape(double depth);

} // namespace plumbline
