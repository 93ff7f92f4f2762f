#include "image_file.h"
