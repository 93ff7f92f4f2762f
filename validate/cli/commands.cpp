#include "validate/cli/command.h"

namespace plumbline {

// In NAME_command.cpp each, the last two in worker_commands.cpp.
Command validateCommand();
Command referenceCommand();
Command realtimeCommand();
Command compareCommand();
Command newCommand();
Command historyCommand();
Command bakeCommand();
Command studyCommand();
Command listCommand();
Command doctorCommand();
Command drawWorkerCommand();
Command studyCaseCommand();

std::span<const Command> commands() {
    static const Command table[] = {
        validateCommand(), referenceCommand(), realtimeCommand(),   compareCommand(),
        newCommand(),      historyCommand(),   bakeCommand(),       studyCommand(),
        listCommand(),     doctorCommand(),    drawWorkerCommand(), studyCaseCommand(),
    };
    return table;
}

} // namespace plumbline
