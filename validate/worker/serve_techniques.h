// The process that draws techniques for a TechniqueWorker.
#pragma once

#include <sys/types.h>

namespace plumbline {

/// Draws the techniques that the process `parent` requests, until that ends. Returns an exit code.
int serveTechniques(pid_t parent);

} // namespace plumbline
