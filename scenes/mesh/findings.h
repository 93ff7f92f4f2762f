// Occurrences of one kind of defect: the first one is described, the others are counted.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

namespace plumbline {

struct Findings {
    std::string first;
    size_t count = 0;

    template <class Describe>
    void add(const Describe& describe) {
        if (count++ == 0) first = describe();
    }
    /// Appends `meaning` to the description of the first occurrence, then the count of the others.
    void report(std::vector<std::string>& warnings, const char* meaning) const {
        if (count == 0) return;
        warnings.push_back(first + meaning + (count > 1 ? fmt::format(" (and {} more)", count - 1) : ""));
    }
};

} // namespace plumbline
