// The program: its command line read, what it asks for run, errors to one line and an exit code. What is done
// is in cli/.
#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/core/program_name.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/standard_output.h"
#include "validate/cli/usage.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

namespace plumbline {
namespace {

using RunOfCommand = std::pair<const CLI::App*, CommandRun>;

std::vector<RunOfCommand> addCommands(CLI::App& app) {
    std::vector<RunOfCommand> runs;
    for (const Command& command : commands()) {
        CLI::App* added = app.add_subcommand(command.name, command.summary);
        if (added->get_description().empty()) added->group(""); // hidden
        runs.emplace_back(added, command.addOptions(*added));
    }
    return runs;
}

int runProgram(int argc, char** argv) {
    CLI::App app("Compares fast approximations of displaced surfaces with a ray-traced reference.",
                 "plumbline");
    app.set_version_flag("--version", programName());
    app.require_subcommand(1);
    const std::vector<RunOfCommand> runs = addCommands(app);
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
    const auto chosen =
        std::find_if(runs.begin(), runs.end(), [](const auto& run) { return run.first->parsed(); });
    return chosen->second();
}

/// runProgram, whose output has arrived when this returns.
int runToTheEnd(int argc, char** argv) {
    const int exitCode = runProgram(argc, argv);
    finishStandardOutput();
    return exitCode;
}

int fail(int exitCode, const std::string& message) {
    std::fputs((printable(message) + "\n").c_str(), stderr); // one error, one line
    return exitCode;
}

constexpr const char* kNoMemory =
    "plumbline: this machine doesn't have enough memory; expected a smaller scene or frame\n";
constexpr const char* kNoThreads =
    "plumbline: this machine lacks threads or memory for them; expected a higher "
    "limit (ulimit -u) or fewer with --threads";

/// TBB throws a runtime_error with this text where a thread can't be started.
bool lacksThreads(const std::exception& error) {
    const auto* code = dynamic_cast<const std::system_error*>(&error);
    return (code && code->code() == std::errc::resource_unavailable_try_again) ||
           std::string_view(error.what()).find("pthread_create") != std::string_view::npos;
}

/// The line and exit code of what was thrown.
int failWith(const std::exception_ptr& thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const InputError& error) {
        return fail(kExitBadInput, error.what());
    } catch (const MachineError& error) {
        return fail(kExitMachine, error.what());
    } catch (const std::filesystem::filesystem_error& error) { // a path that nothing expected
        return fail(kExitBadInput, InputError(error.path1().string(), error.code().message()).what());
    } catch (const std::bad_alloc&) {
        std::fputs(kNoMemory, stderr); // without any for a copy
        return kExitMachine;
    } catch (const std::exception& error) {
        if (lacksThreads(error)) return fail(kExitMachine, kNoThreads);
        if (std::ferror(stdout) != 0)
            return fail(kExitMachine, unwrittenOutput().what()); // fmt::print throws
        return fail(kExitInternal, std::string("internal error: ") + error.what());
    }
}

/// An exception that no caller can catch: of a thread of a library, or of one of its functions that promises
/// to throw none, as TBB's and OpenImageIO's do without memory. The files left are removed by the next run.
[[noreturn]] void endForUncaught() {
    const std::exception_ptr thrown = std::current_exception();
    if (!thrown) std::abort();
    std::_Exit(failWith(thrown));
}

} // namespace
} // namespace plumbline

int main(int argc, char** argv) {
    using namespace plumbline;
    std::signal(SIGXFSZ, SIG_IGN); // a file-size limit is an error of write() then
    std::set_terminate(endForUncaught);
    openClosedStreams();
    try {
        return runToTheEnd(argc, argv);
    } catch (...) {
        return failWith(std::current_exception());
    }
}
