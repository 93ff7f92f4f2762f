#include "frame_exr.h"
