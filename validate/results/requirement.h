// What a run must reach: "silhouette.iou >= 0.99", from --require or a scene's [require].
//
//     KEY[@OBJECT] OPERATOR NUMBER
// KEY: of metricTable(); of figures of lights also with a light, "shadow.sun.agreement", else every light
// must reach it. @OBJECT: the figure of that object, else the pooled one. OPERATOR: >= > <= <. Spaces don't
// matter.
#pragma once

#include "validate/metrics/figure.h"

#include <span>
#include <string>
#include <vector>

namespace plumbline {

struct TechniqueOutcome;

struct Requirement {
    std::string text;       // "silhouette.iou@torus >= 0.99"
    std::string where;      // it was given, for messages
    std::string key;        // of metricTable()
    std::string light;      // empty: every light
    std::string object;     // empty: pooled
    std::string comparison; // ">=", ">", "<=" or "<"
    double bound = 0;
};

/// How a technique stands to a requirement; of one on every light, to that of one light.
struct RequirementResult {
    std::string requirement; // its text
    std::string key; // with the light, "shadow.sun.agreement"; with the object, "silhouette.iou@torus"
    Figure value;
    bool passed = false; // never where there is no value
};

/// Throws InputError that begins with `where` for a text not of the form or a metric there isn't.
Requirement parseRequirement(const std::string& text, const std::string& where);

/// Throws InputError for a light or an object that isn't among these.
void checkNames(const Requirement& requirement, std::span<const std::string> lights,
                std::span<const std::string> objects);

/// One result a requirement, or one a light of it; a technique that wasn't drawn reaches none.
std::vector<RequirementResult> holdAgainst(std::span<const Requirement> requirements,
                                           const TechniqueOutcome& technique);

} // namespace plumbline
