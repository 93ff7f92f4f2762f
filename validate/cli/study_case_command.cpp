#include "realtime/gl/gl_probe.h"
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

int runStudyCase(const Arguments& arguments) {
    requireGlBuild(kStudyCaseCommand);
    const ThreadLimit limit(arguments.threads.threads);
    return serveStudyCase(arguments.parent);
}

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
