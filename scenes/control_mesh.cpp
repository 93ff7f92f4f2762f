#include "control_mesh.h"
