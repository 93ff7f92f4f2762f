#include "scene_file.h"
