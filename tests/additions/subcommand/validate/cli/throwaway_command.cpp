#include "validate/cli/command.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace plumbline {

Command throwawayCommand() {
    return {"throwaway", "Print a number", [](CLI::App& command) {
                const auto number = std::make_shared<int>(0);
                command.add_option("NUMBER", *number, "what to print")->required();
                return CommandRun([number] {
                    fmt::print("throw-away {}\n", *number);
                    return 0;
                });
            }};
}

} // namespace plumbline
