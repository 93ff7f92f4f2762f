// A command of the program: its name, its line in --help, its options and what it does. Each is in a file of
// its own, NAME_command.cpp, those for the program itself in worker_commands.cpp; commands.cpp lists them.
#pragma once

#include <functional>
#include <span>

namespace CLI {
class App;
}

namespace plumbline {

/// Does what a command line asks for and returns an exit code (exit_codes.h). Throws InputError or
/// MachineError, which main.cpp turns into one line on stderr. Prints results to stdout, progress to stderr
/// when that is a terminal.
using CommandRun = std::function<int()>;

struct Command {
    const char* name;
    const char* summary; // one line; empty: for the program itself, --help doesn't list it
    /// Adds its options to `command`. The result owns what they are read into and is called after that.
    CommandRun (*addOptions)(CLI::App& command);
};

/// Every command, in the order of --help.
std::span<const Command> commands();

} // namespace plumbline
