// The figures of a technique in results.json by their dotted names: "shadow.sun.iou".
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <string>

namespace plumbline {

/// Adds the numbers of `value`, an object, under names that begin with `prefix`, if there is one. Left out:
/// those of single objects, reasons, parameters, lists, and what is nested deeper than any result is.
void addFlatFigures(const nlohmann::json& value, const std::string& prefix,
                    std::map<std::string, double>& figures);

} // namespace plumbline
