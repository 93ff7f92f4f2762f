// What is wrong with a command line, as errors of ours.
#pragma once

#include "scenes/core/error.h"

#include <CLI/CLI.hpp>

#include <string>

namespace plumbline {

/// A message of CLI11 as one of ours, with a guess at what was meant.
InputError usageError(const CLI::App& app, const CLI::ParseError& error);

/// Throws InputError if `first`, the first argument, is no command; CLI11 would only say that one is missing.
void requireCommand(const CLI::App& app, const std::string& first);

} // namespace plumbline
