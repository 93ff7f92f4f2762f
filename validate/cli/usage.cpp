#include "validate/cli/usage.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

/// The command the arguments got to, with its names from the first on: "study run"; the program itself if
/// they got to none.
std::pair<const CLI::App*, std::string> commandUsed(const CLI::App& app) {
    const CLI::App* command = &app;
    std::string names;
    while (!command->get_subcommands().empty()) {
        command = command->get_subcommands()[0];
        names += (names.empty() ? "" : " ") + command->get_name();
    }
    return {command, names.empty() ? "plumbline" : names};
}

} // namespace

InputError usageError(const CLI::App& app, const CLI::ParseError& error) {
    const auto [command, where] = commandUsed(app);
    const std::string help =
        fmt::format("'plumbline {}--help' lists the choices", command == &app ? "" : where + " ");
    std::vector<std::string> choices;
    for (const CLI::App* sub : command->get_subcommands({}))
        choices.push_back(sub->get_name());
    const std::vector<std::string> unknown = command->remaining();
    if (command != &app && !choices.empty())
        return {where,
                unknown.empty() ? "a subcommand is missing" : fmt::format("there is no '{}'", unknown[0]),
                listOf(choices), unknown.empty() ? "" : didYouMean(unknown[0], choices)};
    for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames())
            choices.push_back("--" + name);
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !unknown.empty()) {
        const std::string guess = didYouMean(unknown[0], choices);
        return {where, fmt::format("'{}' was not expected", unknown[0]), "", guess.empty() ? help : guess};
    }
    return {where, error.what(), "", help};
}

void requireCommand(const CLI::App& app, const std::string& first) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        if (command->get_name() == first) return;
        if (!command->get_group().empty()) names.push_back(command->get_name());
    }
    for (const char* option : {"-h", "--help", "--version"})
        names.emplace_back(option);
    if (std::find(names.begin(), names.end(), first) != names.end()) return;
    throw InputError("plumbline", fmt::format("there is no command '{}'", first), listOf(names),
                     didYouMean(first, names));
}

} // namespace plumbline
