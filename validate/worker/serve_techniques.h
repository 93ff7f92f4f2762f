// The process that draws for a TechniqueWorker.
#pragma once

#include <sys/types.h>

namespace plumbline {

/// Draws what the process `parent` asks for until that is gone. Returns an exit code.
int serveTechniques(pid_t parent);

} // namespace plumbline
