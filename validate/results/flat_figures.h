// The figures of a technique in results.json by their dotted names: "shadow.sun.iou".
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <string>

namespace plumbline {

/// Adds the numbers of `value`, a JSON object, under names that begin with `prefix` (if not empty). Figures
/// of single objects, reasons, parameters, lists and values nested deeper than in any result are left out.
void addFlatFigures(const nlohmann::json& value, const std::string& prefix,
                    std::map<std::string, double>& figures);

} // namespace plumbline
