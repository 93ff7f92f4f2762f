// The command line as CLI11 has it: which commands there are, what they take, and what the one chosen is to
// run.
#pragma once

#include "validate/cli/commands.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace plumbline {

struct Arguments {
    ReferenceArguments reference;
    RealtimeArguments realtime;
    ValidateArguments validate;
    CompareArguments compare;
    BakeArguments bake;
    StudyArguments study;
    NewArguments fresh;
    HistoryArguments history;
    std::string listed;
    int threads = 0; // 0: as many as the machine has
    int parent = 0;  // of a drawing process
};

/// Adds the commands to `app`; the one chosen stores what is to be run in `run`.
void addCommands(CLI::App& app, Arguments& arguments, std::function<int()>& run);

// Options that several commands share.
void addThreads(CLI::App& command, Arguments& arguments);
void addScene(CLI::App& command, std::string& scene, std::vector<std::string>& changes,
              const std::string& help);
void addReportOptions(CLI::App& command, ReportArguments& arguments);
/// `bases`: what --base may be.
void addReferenceOptions(CLI::App& command, ReferenceArguments& arguments, const char* bases);
void addExports(CLI::App& command, ReferenceArguments& arguments);
void addRealtimeOptions(CLI::App& command, RealtimeArguments& arguments);
void addRequire(CLI::App& command, std::vector<std::string>& require);
void addChannelMap(CLI::App& command, CompareArguments& arguments);

} // namespace plumbline
