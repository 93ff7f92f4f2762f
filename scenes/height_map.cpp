#include "height_map.h"
