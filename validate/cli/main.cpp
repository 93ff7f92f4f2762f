// The program: its command line read, what it asks for run, errors to one line and an exit code. What is done
// is in cli/.
#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/core/program_name.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/usage.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
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

int fail(int exitCode, const std::string& message) {
    std::fputs((printable(message) + "\n").c_str(), stderr); // one error, one line
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
                    "plumbline: this machine doesn't have enough memory; expected a smaller scene or frame");
    } catch (const std::exception& error) {
        return fail(kExitInternal, std::string("internal error: ") + error.what());
    }
}
