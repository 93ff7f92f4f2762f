// Errors of the command line as InputError.
#pragma once

#include "scenes/core/error.h"

#include <CLI/CLI.hpp>

#include <string>

namespace plumbline {

/// Converts an error of CLI11, with a suggestion of what was meant.
InputError usageError(const CLI::App& app, const CLI::ParseError& error);

/// Throws InputError if `first`, the first argument, is no command; CLI11 would only say that one is missing.
void requireCommand(const CLI::App& app, const std::string& first);

} // namespace plumbline
