#include "validate/study/study_cases.h"

#include "scenes/core/content_hash.h"
#include "scenes/core/error.h"
#include "scenes/core/program_name.h"
#include "scenes/toml/toml_table.h"

#include <algorithm>
#include <limits>

namespace plumbline {
namespace {

/// Fields whose value is a file.
bool namesFile(const std::string& field) {
    const std::string last = field.substr(field.rfind('.') + 1);
    return last == "mesh" || last == "file" || last == "color_map";
}

/// Adds a change and the contents of the file that it names.
void addChange(ContentHash& hash, const std::string& change, const std::filesystem::path& sceneFile) {
    hash.add(change);
    const size_t equals = change.find('=');
    if (equals == std::string::npos || !namesFile(change.substr(0, equals))) return;
    try {
        const TomlTable value = TomlTable::parse("", "file = " + change.substr(equals + 1));
        hash.addFile(sceneFile.parent_path() / value.text("file"));
    } catch (const InputError&) { // not a text, or no such file: the case itself reports the error
    }
}

class CaseMaker {
  public:
    CaseMaker(const Study& study, const StudyGrid& grid, const std::string& techniquesHash)
        : study_(study), grid_(grid), techniquesHash_(techniquesHash) {}

    void addCases(size_t scene, const std::string& sceneHash, std::vector<StudyCase>& cases) const {
        std::vector<size_t> at(grid_.axes.size(), 0);
        for (;;) {
            cases.push_back(makeCase(scene, sceneHash, at));
            size_t axis = at.size();
            while (axis > 0 && ++at[axis - 1] == grid_.axes[axis - 1].values.size())
                at[--axis] = 0;
            if (axis == 0) return;
        }
    }

  private:
    StudyCase makeCase(size_t scene, const std::string& sceneHash, const std::vector<size_t>& at) const {
        StudyCase result;
        result.grid = &grid_;
        result.scene = grid_.scenes[scene];
        result.sceneFile = grid_.sceneFiles[scene];
        result.changes = grid_.sceneChanges;
        for (size_t i = 0; i < at.size(); ++i) {
            const StudyAxis& axis = grid_.axes[i];
            result.values[axis.name] = axis.values[at[i]];
            for (const std::string& field : axis.fields)
                result.changes.push_back(field + "=" + axis.values[at[i]]);
        }
        ContentHash hash;
        for (const std::string& text :
             {programName(), sceneHash, techniquesHash_, study_.memory, study_.errorPx})
            hash.add(text);
        hash.add(std::to_string(grid_.timingBudgetMs));
        hash.add(std::to_string(study_.timeLimitSeconds));
        for (const std::string& change : result.changes)
            addChange(hash, change, result.sceneFile);
        result.id = hash.hexadecimal();
        return result;
    }

    const Study& study_;
    const StudyGrid& grid_;
    const std::string& techniquesHash_;
};

uint64_t times(uint64_t a, uint64_t b) {
    constexpr uint64_t kMost = std::numeric_limits<uint64_t>::max();
    return b != 0 && a > kMost / b ? kMost : a * b;
}

} // namespace

uint64_t caseCount(const Study& study) {
    uint64_t count = 0;
    for (const StudyGrid& grid : study.grids) {
        uint64_t cases = grid.scenes.size();
        for (const StudyAxis& axis : grid.axes)
            cases = times(cases, axis.values.size());
        count = cases > std::numeric_limits<uint64_t>::max() - count ? std::numeric_limits<uint64_t>::max()
                                                                     : count + cases;
    }
    return count;
}

std::vector<StudyCase> casesOf(const Study& study,
                               const std::function<std::string(const StudyGrid&)>& techniquesHash) {
    std::map<std::filesystem::path, std::string> sceneHashes;
    std::vector<StudyCase> cases;
    for (const StudyGrid& grid : study.grids) {
        const std::string hash = techniquesHash(grid);
        const CaseMaker maker(study, grid, hash);
        for (size_t scene = 0; scene < grid.scenes.size(); ++scene) {
            std::string& sceneHash = sceneHashes[grid.sceneFiles[scene]];
            if (sceneHash.empty()) sceneHash = readScene(grid.sceneFiles[scene]).hash;
            maker.addCases(scene, sceneHash, cases);
        }
    }
    return cases;
}

} // namespace plumbline
