// Names that a parameter of a technique or surface can't have.
#pragma once

#include <string>

namespace plumbline {

/// Whether a parameter of that name couldn't be told from something else: a declaration of the harness
/// (harnessNames in stage_sources.h) or of a surface of the library, a setting of the harness
/// (harness_parameters.h), a kind of baked map.
bool isReserved(const std::string& name);

} // namespace plumbline
