// --single-file and --plain-report.
#pragma once

#include "validate/report/report.h"

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

} // namespace plumbline
