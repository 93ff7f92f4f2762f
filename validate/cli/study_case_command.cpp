#include "scenes/core/error.h"
#include "validate/cli/case_pool.h"
#include "validate/cli/command.h"
#include "validate/cli/thread_arguments.h"

#include <CLI/CLI.hpp>

namespace plumbline {
namespace {

struct Arguments {
    int parent = 0; // the process that started this one and is served by it
    ThreadArguments threads;
};

#ifdef PLUMBLINE_GL
int runStudyCase(const Arguments& arguments) {
    const ThreadLimit limit(arguments.threads.threads);
    return serveStudyCase(arguments.parent);
}
#else
int runStudyCase(const Arguments&) {
    throw MachineError(kStudyCaseCommand, "this program was built without OpenGL (preset no-gl)");
}
#endif

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    command.add_option("PARENT", arguments->parent, "");
    command.add_option("--threads", arguments->threads.threads, "");
    return [arguments] { return runStudyCase(*arguments); };
}

} // namespace

Command studyCaseCommand() {
    return {kStudyCaseCommand, "", addOptions};
}

} // namespace plumbline
