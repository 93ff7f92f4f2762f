// Reads and renders the templates of validate/report/page/.
#pragma once

#include <kainjow/mustache.hpp>

#include <string>

namespace plumbline::report {

/// Throws MachineError if it can't be read.
std::string readTemplate(const char* name);

/// Renders a template with the data `page`. Throws MachineError for an invalid template.
std::string renderTemplate(const char* name, const kainjow::mustache::data& page);

} // namespace plumbline::report
