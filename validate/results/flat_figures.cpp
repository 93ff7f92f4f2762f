#include "validate/results/flat_figures.h"

#include <nlohmann/json.hpp>

#include <set>

namespace plumbline {
namespace {

/// Parts of a result that are no figures of the whole picture.
const std::set<std::string> kSkipped{"objects", "absent", "parameters", "gl", "notes", "pooled_objects"};
/// against_proxy.shadow.sun.iou has three; a file that isn't ours may have any number.
constexpr int kDeepest = 8;

void add(const nlohmann::json& value, const std::string& prefix, int depth,
         std::map<std::string, double>& figures) {
    for (const auto& [key, element] : value.items()) {
        const std::string name = prefix.empty() ? key : prefix + "." + key;
        if (depth == 0 && kSkipped.contains(key)) continue;
        if (element.is_number())
            figures[name] = element.get<double>();
        else if (element.is_object() && depth < kDeepest)
            add(element, name, depth + 1, figures);
    }
}

} // namespace

void addFlatFigures(const nlohmann::json& value, const std::string& prefix,
                    std::map<std::string, double>& figures) {
    add(value, prefix, 0, figures);
}

} // namespace plumbline
