#include "base_surface.h"
