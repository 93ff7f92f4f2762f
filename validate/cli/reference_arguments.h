// Options of the reference: --base, --error-px, --rate, --memory.
#pragma once

#include "reference/reference.h"

namespace CLI {
class App;
}

namespace plumbline {

/// Which references a run draws.
enum class BaseChoice { Limit, Proxy, Both };

struct ReferenceArguments {
    BaseChoice base = BaseChoice::Limit;
    ReferenceOptions options; // all but the base; what isn't given has the reference's own default

    /// `bothIsAChoice`: of --base, beside limit and proxy.
    void addTo(CLI::App& command, bool bothIsAChoice);
};

} // namespace plumbline
