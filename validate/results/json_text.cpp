#include "validate/results/json_text.h"

#include "scenes/core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace plumbline {

using nlohmann::json;

json parseJson(const std::string& where, const std::string& text) {
    constexpr int kDeepest = 100; // results have 10
    const auto checkDepth = [&](int depth, json::parse_event_t, const json&) {
        if (depth > kDeepest)
            throw InputError(where, fmt::format("has values more than {} deep within each other", kDeepest),
                             "a few");
        return true;
    };
    return json::parse(text, checkDepth, false);
}

} // namespace plumbline
