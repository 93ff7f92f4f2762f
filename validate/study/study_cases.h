// The cases of a study. Each has an id computed from its contents, so that stored results are found again.
#pragma once

#include "scenes/scene_file/scene_file.h"
#include "validate/study/study.h"

#include <functional>

namespace plumbline {

struct StudyCase {
    const StudyGrid* grid = nullptr;
    std::string scene; // as named in the study
    std::filesystem::path sceneFile;
    std::map<std::string, std::string> values; // by axis
    SceneChanges changes;                      // of the grid and the axes
    /// Hash of scene, changes, techniques and all else that determines its results; 32 hexadecimal digits.
    std::string id;
};

/// Number of cases, without creating them; saturates at the largest uint64_t.
uint64_t caseCount(const Study& study);

/// All cases: grid by grid, scene by scene, with the last axis changing fastest. `techniquesHash`: returns a
/// hash of all that determines what the techniques of a grid draw. Reads each scene once. Throws InputError
/// for a scene that can't be read.
std::vector<StudyCase> casesOf(const Study& study,
                               const std::function<std::string(const StudyGrid&)>& techniquesHash);

} // namespace plumbline
