// The cases of a study, each with a name made of its contents, so that what was worked out once is found
// again.
#pragma once

#include "scenes/scene_file/scene_file.h"
#include "validate/study/study.h"

#include <functional>

namespace plumbline {

struct StudyCase {
    const StudyGrid* grid = nullptr;
    std::string scene; // as the study names it
    std::filesystem::path sceneFile;
    std::map<std::string, std::string> values; // by axis
    SceneChanges changes;                      // the grid's and the axes'
    /// Of scene, changes, techniques and what else decides its results; 32 hexadecimal digits.
    std::string id;
};

/// Number of cases, without making them; stays at the largest number there is.
uint64_t caseCount(const Study& study);

/// All of them: grid by grid, scene by scene, the last axis changing fastest. `techniquesHash`: of whatever
/// decides what the techniques of a grid draw. Reads each scene once. Throws InputError for a scene that
/// can't be read.
std::vector<StudyCase> casesOf(const Study& study,
                               const std::function<std::string(const StudyGrid&)>& techniquesHash);

} // namespace plumbline
