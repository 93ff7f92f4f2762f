#include "scenes/core/program_name.h"

namespace plumbline {

std::string programName() {
    return "plumbline " PLUMBLINE_VERSION;
}

} // namespace plumbline
