#include "obj_file.h"
