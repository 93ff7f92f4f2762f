#include "validate/results/flat_figures.h"

#include <nlohmann/json.hpp>

#include <set>

namespace plumbline {
namespace {

/// Parts of a result that aren't figures of the whole image.
const std::set<std::string> kSkipped{"objects", "absent", "parameters", "gl", "notes", "pooled_objects"};
/// against_proxy.shadow.sun.iou has three levels; files of other programs may have any number.
constexpr int kMaxDepth = 8;

void add(const nlohmann::json& value, const std::string& prefix, int depth,
         std::map<std::string, double>& figures) {
    for (const auto& [key, element] : value.items()) {
        const std::string name = prefix.empty() ? key : prefix + "." + key;
        if (depth == 0 && kSkipped.contains(key)) continue;
        if (element.is_number())
            figures[name] = element.get<double>();
        else if (element.is_object() && depth < kMaxDepth)
            add(element, name, depth + 1, figures);
    }
}

} // namespace

void addFlatFigures(const nlohmann::json& value, const std::string& prefix,
                    std::map<std::string, double>& figures) {
    add(value, prefix, 0, figures);
}

} // namespace plumbline
