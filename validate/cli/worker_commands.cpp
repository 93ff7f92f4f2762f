// The commands by which the program starts itself to work for another of its processes.
#include "realtime/gl/gl_probe.h"
#include "validate/cli/case_pool.h"
#include "validate/cli/command.h"
#include "validate/cli/thread_arguments.h"
#include "validate/worker/serve_techniques.h"
#include "validate/worker/technique_worker.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace plumbline {
namespace {

struct Arguments {
    int parent = 0; // the process that started this one and is served by it
    ThreadArguments threads;
};

/// Serves the process `parent` until that is gone; returns an exit code.
using Serve = int (*)(int parent);

int runWorker(const char* name, Serve serve, const Arguments& arguments) {
    requireGlBuild(name);
    const ThreadLimit limit(arguments.threads.threads);
    return serve(arguments.parent);
}

CommandRun addOptions(CLI::App& command, const char* name, Serve serve) {
    const auto arguments = std::make_shared<Arguments>();
    command.add_option("PARENT", arguments->parent, "");
    command.add_option("--threads", arguments->threads.threads, ""); // also 0
    return [=] { return runWorker(name, serve, *arguments); };
}

} // namespace

Command drawWorkerCommand() {
    return {kDrawWorkerCommand, "",
            [](CLI::App& command) { return addOptions(command, kDrawWorkerCommand, serveTechniques); }};
}

Command studyCaseCommand() {
    return {kStudyCaseCommand, "",
            [](CLI::App& command) { return addOptions(command, kStudyCaseCommand, serveStudyCase); }};
}

} // namespace plumbline
