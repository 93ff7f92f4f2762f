// Options of the reference: --base, --error-px, --rate, --memory.
#pragma once

#include "reference/reference.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace plumbline {

struct ReferenceArguments {
    std::string base = "limit"; // or "proxy"; for validate also "both"
    std::optional<std::string> errorPx;
    int rate = 0;                      // segments per control edge; 0: chosen
    std::optional<std::string> memory; // "256M"

    /// `bases`: what --base may be, for --help.
    void addTo(CLI::App& command, const char* bases);
    /// All but the base, which parseBase reads. What isn't given has the reference's own default. Throws
    /// InputError.
    ReferenceOptions options() const;
};

} // namespace plumbline
