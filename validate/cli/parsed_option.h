// Options whose texts are read into typed values while CLI11 reads the command line.
//
// The parsers throw InputError, which passes through CLI11 to main() as it is. Validators and transformers of
// CLI11 aren't used for these: it puts words of its own around theirs, IsMember makes no guess at what was
// meant, and AsSizeValue also takes "kb" and has no bounds. Where a Range says it all, it is used.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <utility>

namespace plumbline {

/// Sets `value`, which must outlive the parsing, to parse(TEXT). `Text`: std::string, or for an option that
/// may be repeated std::vector<std::string>.
template <class Text = std::string, class Value, class Parse>
CLI::Option* addParsed(CLI::App& command, const std::string& name, Value& value, Parse parse,
                       const std::string& help) {
    return command.add_option_function<Text>(
        name, [&value, parse = std::move(parse)](const Text& text) { value = parse(text); }, help);
}

} // namespace plumbline
