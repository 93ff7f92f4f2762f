// --single-file and --plain-report, and what a command says of the report it wrote.
#pragma once

#include "validate/report/report.h"

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace plumbline {

struct ReportArguments {
    bool singleFile = false; // index.html only
    bool plain = false;      // without scripts, though the program may hold them

    void addTo(CLI::App& command);
    /// The interactive page where the program holds it and nobody asked for a plain one.
    ReportOptions options() const;
};

/// Where the report is, and why it is a plain one if it is: a line for stdout.
std::string reportLine(const std::filesystem::path& page);

} // namespace plumbline
