#include "proxy_mesh.h"
