#include "realtime/gl/gl_probe.h"
#include "validate/cli/command.h"
#include "validate/cli/thread_arguments.h"
#include "validate/worker/serve_techniques.h"
#include "validate/worker/technique_worker.h"

#include <CLI/CLI.hpp>

namespace plumbline {
namespace {

struct Arguments {
    int parent = 0; // the process that started this one and is served by it
    ThreadArguments threads;
};

int runDrawWorker(const Arguments& arguments) {
    requireGlBuild(kDrawWorkerCommand);
    const ThreadLimit limit(arguments.threads.threads);
    return serveTechniques(arguments.parent);
}

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    command.add_option("PARENT", arguments->parent, "");
    command.add_option("--threads", arguments->threads.threads, ""); // also 0
    return [arguments] { return runDrawWorker(*arguments); };
}

} // namespace

Command drawWorkerCommand() {
    return {kDrawWorkerCommand, "", addOptions};
}

} // namespace plumbline
