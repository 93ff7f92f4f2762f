#include "scenes/core/error.h"

#include "scenes/core/printable.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace plumbline {
namespace {

std::string compose(std::string_view where, std::string_view what, std::string_view expected,
                    std::string_view hint) {
    std::string message;
    if (!where.empty()) message.append(where).append(": ");
    message.append(what);
    if (!expected.empty()) message.append("; expected ").append(expected);
    if (!hint.empty()) message.append("; ").append(hint);
    return printable(message); // one line, whatever names it holds
}

std::string lowerCase(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// Edit distance with insertions, deletions, substitutions and transpositions of adjacent characters (optimal
/// string alignment).
size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<size_t> beforePrevious(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j)
        previous[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t substituted = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({substituted, previous[j] + 1, current[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], beforePrevious[j - 2] + 1);
        }
        std::swap(beforePrevious, previous);
        std::swap(previous, current);
    }
    return previous[b.size()];
}

} // namespace

InputError::InputError(std::string_view where, std::string_view what, std::string_view expected,
                       std::string_view hint)
    : std::runtime_error(compose(where, what, expected, hint)) {}

MachineError::MachineError(std::string_view where, std::string_view what, std::string_view expected,
                           std::string_view hint)
    : std::runtime_error(compose(where, what, expected, hint)) {}

std::string didYouMean(std::string_view name, std::span<const std::string> choices) {
    // Longer names come from corrupt data, not from typing errors.
    constexpr size_t kLongestName = 100;
    if (name.empty() || name.size() > kLongestName) return {};
    const std::string lowered = lowerCase(name);
    const std::string* nearest = nullptr;
    size_t nearestDistance = 0;
    for (const std::string& choice : choices) {
        const size_t distance = editDistance(lowered, lowerCase(choice));
        if (!nearest || distance < nearestDistance) {
            nearest = &choice;
            nearestDistance = distance;
        }
    }
    // A third of the letters may differ, at least one; never all of them.
    if (!nearest || nearestDistance > std::max<size_t>(1, name.size() / 3)) return {};
    if (nearestDistance >= std::max(name.size(), nearest->size())) return {};
    return "did you mean '" + *nearest + "'?";
}

std::string listOf(std::span<const std::string> choices) {
    std::string text;
    for (size_t i = 0; i < choices.size(); ++i) {
        if (i > 0) text += i + 1 == choices.size() ? " or " : ", ";
        text += choices[i];
    }
    return text;
}

} // namespace plumbline
