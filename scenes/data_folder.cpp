#include "data_folder.h"
