#include "generate_map.h"
