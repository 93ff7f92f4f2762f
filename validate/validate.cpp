#include "../reference/reference.h"
