// Requirements on the figures of a run: "silhouette.iou >= 0.99", from --require or a scene's [require].
//
//     KEY[@OBJECT] OPERATOR NUMBER
// KEY: of metricTable(). With a light ("shadow.sun.agreement") it applies to that light, without one to every
// light. With @OBJECT the figure of that object is evaluated, otherwise the pooled one. OPERATOR: >= > <= <.
// Spaces are ignored.
#pragma once

#include "validate/metrics/figure.h"

#include <span>
#include <string>
#include <vector>

namespace plumbline {

struct TechniqueOutcome;

struct Requirement {
    std::string text;       // "silhouette.iou@torus >= 0.99"
    std::string where;      // source of the requirement, for messages
    std::string key;        // of metricTable()
    std::string light;      // empty: every light
    std::string object;     // empty: pooled
    std::string comparison; // ">=", ">", "<=" or "<"
    double bound = 0;
};

/// Result of a requirement for a technique; if it applies to every light, there is one for each.
struct RequirementResult {
    std::string requirement; // its text
    std::string key; // with the light, "shadow.sun.agreement"; with the object, "silhouette.iou@torus"
    Figure value;
    bool passed = false; // false if the figure is absent
};

/// Throws InputError, located at `where`, for a text that isn't of this form or an unknown metric.
Requirement parseRequirement(const std::string& text, const std::string& where);

/// Throws InputError for an unknown light or object.
void checkNames(const Requirement& requirement, std::span<const std::string> lights,
                std::span<const std::string> objects);

/// One result for each requirement, or for each light of it. A technique that failed reaches none.
std::vector<RequirementResult> evaluateRequirements(std::span<const Requirement> requirements,
                                                    const TechniqueOutcome& technique);

} // namespace plumbline
