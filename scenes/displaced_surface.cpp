#include "displaced_surface.h"
