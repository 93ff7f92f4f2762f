// The program: its command line read, what it asks for run, errors to one line and an exit code. What is done
// is in cli/.
#include "scenes/core/error.h"
#include "scenes/frame/scene_metadata.h"
#include "validate/cli/command_line.h"
#include "validate/cli/usage.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>

namespace plumbline {
namespace {

void limitThreads(int threads, std::unique_ptr<tbb::global_control>& control) {
    if (threads == 0) return;
    control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<size_t>(threads));
    ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1); // llvmpipe reads it when GL starts
}

int runProgram(int argc, char** argv) {
    CLI::App app("Holds fast approximations of displaced surfaces against a true one.", "plumbline");
    app.set_version_flag("--version", programName());
    app.require_subcommand(1);
    Arguments arguments;
    std::function<int()> run;
    addCommands(app, arguments, run);
    if (argc < 2) {
        std::fputs(app.help().c_str(), stderr);
        return kExitBadInput;
    }
    requireCommand(app, argv[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help and --version
        throw usageError(app, error);
    }
    std::unique_ptr<tbb::global_control> control;
    limitThreads(arguments.threads, control);
    return run();
}

int fail(int exitCode, std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' '); // one error, one line
    std::fputs((message + "\n").c_str(), stderr);
    return exitCode;
}

} // namespace
} // namespace plumbline

int main(int argc, char** argv) {
    using namespace plumbline;
    try {
        return runProgram(argc, argv);
    } catch (const InputError& error) {
        return fail(kExitBadInput, error.what());
    } catch (const MachineError& error) {
        return fail(kExitMachine, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kExitMachine,
                    "plumbline: this machine hasn't the memory for that; expected a smaller scene or frame");
    } catch (const std::exception& error) {
        return fail(kExitInternal, std::string("internal error: ") + error.what());
    }
}
