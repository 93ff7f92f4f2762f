#include "validate/results/unique_file_names.h"

#include <fmt/format.h>

#include <cctype>

namespace plumbline {
namespace {

/// Safe names are ASCII.
std::string lowerCase(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

} // namespace

std::string UniqueFileNames::add(const std::string& safeName) {
    std::string unique = safeName;
    for (int number = 2; !taken_.insert(lowerCase(unique)).second; ++number)
        unique = fmt::format("{}_{}", safeName, number);
    return unique;
}

} // namespace plumbline
