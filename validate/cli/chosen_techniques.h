// The techniques that a command line or a study names; each is resolved once per run.
#pragma once

#include "realtime/technique/technique.h"
#include "scenes/core/error.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// A technique of a run. A fault inside its folder or its settings is reported beside the results of the
/// others.
struct ChosenTechnique {
    std::string name;                   // as results show it; if it can't be resolved, as the user wrote it
    std::optional<Manifest> search;     // none: it can't be read
    std::optional<Technique> technique; // none: it can't be resolved
    std::optional<InputError> error;    // why not

    /// Throws `error` where there is none.
    const Technique& resolved() const;
    /// Whether it draws the reference's micro-triangles.
    bool isControl() const { return search && search->drawsMicroTriangles(); }
};

/// Whether any of them is a control technique: then the reference must keep the attributes it draws.
bool anyControl(const std::vector<ChosenTechnique>& techniques);

/// The techniques of `texts`; with none or with "all", every technique on each of its surfaces, the control
/// technique first. Throws InputError for a text that isn't of the form, a name there is no technique of, one
/// named twice, and a setting that none of them takes.
std::vector<ChosenTechnique> chosenTechniques(const std::vector<std::string>& texts,
                                              const Settings& settings);

} // namespace plumbline
