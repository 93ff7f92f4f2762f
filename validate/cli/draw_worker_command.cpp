#include "scenes/core/error.h"
#include "validate/cli/commands.h"

#ifdef PLUMBLINE_GL
#include "validate/worker/technique_worker.h"
#endif

namespace plumbline {

#ifdef PLUMBLINE_GL
int runDrawWorker(int parent) {
    return serveTechniques(parent);
}
#else
int runDrawWorker(int) {
    throw MachineError(kDrawWorkerCommand, "this program was built without OpenGL (preset no-gl)");
}
#endif

} // namespace plumbline
