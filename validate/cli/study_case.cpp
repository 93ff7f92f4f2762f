#include "validate/cli/study_case.h"

#include "realtime/technique/technique_list.h"
#include "scenes/core/content_hash.h"
#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "scenes/core/nearest_rank.h"
#include "scenes/core/program_name.h"
#include "scenes/frame/object_info.h"
#include "scenes/surface/proxy_mesh.h"
#include "validate/cli/frame_memory.h"
#include "validate/cli/option_values.h"
#include "validate/cli/run_summaries.h"
#include "validate/cli/trial.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The outcomes as results.json has them.
json resultsOf(const Scene& scene, const ReferenceSummary& reference,
               std::vector<TechniqueOutcome> outcomes) {
    return json::parse(
        toJson(Results{programName(), summaryOf(scene), "limit", reference, {}, std::move(outcomes)}));
}

size_t indexOf(const std::vector<std::string>& names, const std::string& name) {
    return static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// The second technique's frame compared with the first's, as its reference.
json comparePair(const Trial& first, const Trial& second, const Scene& scene,
                 const ReferenceSummary& reference) {
    TechniqueOutcome outcome;
    outcome.name = second.outcome.name;
    for (const Trial* trial : {&first, &second})
        if (trial->outcome.error) outcome.error = trial->outcome.error;
    if (!outcome.error)
        outcome.comparison = compareFrames(first.frame, second.frame, objectsOf(scene), scene.camera);
    return resultsOf(scene, reference, {std::move(outcome)})["techniques"][0];
}

/// The technique a label of the grid stands for.
const std::string& nameOf(const StudyGrid& grid, const std::string& label) {
    return std::find_if(grid.techniques.begin(), grid.techniques.end(),
                        [&](const StudyTechnique& technique) { return technique.label == label; })
        ->name;
}

ReferenceOptions referenceOptions(const json& request, const std::vector<ChosenTechnique>& techniques) {
    ReferenceOptions options;
    options.memoryBytes = request.at("reference_bytes");
    options.errorPx = request.at("reference_error_px");
    options.microAttributes = anyControl(techniques);
    return options;
}

WorkerOptions workerOptions(const json& request, const fs::path& sceneFile, const Scene& scene) {
    RealtimeArguments realtime;
    realtime.gl.options.backend = request.at("gl_backend");
    realtime.gl.options.device = request.at("gl_device");
    realtime.gl.options.timingBudgetMs = request.at("timing_budget_ms");
    realtime.drawMemory.bytes = request.at("draw_bytes");
    realtime.timeLimitSeconds = request.at("time_limit");
    return workerOptions(sceneFile, scene, realtime, request.at("threads"));
}

/// How well the rings of the proxies' vertices determine their quadrics: the least squares of RP-351,
/// section 3.1.
json fitOf(const Scene& scene) {
    std::vector<double> conditions;
    size_t vertices = 0, unmapped = 0; // without a direction of s and t: never fitted
    for (const SceneObject& object : scene.objects) {
        if (!object.relief) continue;
        for (const ProxyVertex& vertex : buildProxyMesh(object).vertices) {
            ++vertices;
            unmapped += glm::length(vertex.positionS) == 0;
            if (std::isfinite(vertex.ringQuadric.condition))
                conditions.push_back(vertex.ringQuadric.condition);
        }
    }
    json fit{{"vertices", vertices},
             {"unmapped", unmapped},
             {"singular", vertices - unmapped - conditions.size()}};
    if (conditions.empty()) return fit;
    std::sort(conditions.begin(), conditions.end());
    fit["condition_p50"] = conditions[nearestRankIndex(conditions.size(), 50)];
    fit["condition_p99"] = conditions[nearestRankIndex(conditions.size(), 99)];
    fit["condition_max"] = conditions.back();
    return fit;
}

/// Contents of every file below a folder, in the order of their names.
void addFolder(ContentHash& hash, const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        hash.add(file.filename().string());
        hash.addFile(file);
    }
}

} // namespace

json caseRequest(const StudyCase& studyCase, const CaseOptions& options) {
    std::vector<std::string> names;
    for (const StudyTechnique& technique : studyCase.grid->techniques)
        names.push_back(technique.name);
    json pairs = json::array();
    for (const StudyPair& pair : studyCase.grid->pairs)
        pairs.push_back({nameOf(*studyCase.grid, pair.first), nameOf(*studyCase.grid, pair.second)});
    return {{"scene", studyCase.sceneFile.native()},
            {"changes", studyCase.changes},
            {"techniques", names},
            {"settings", studyCase.grid->settings},
            {"pairs", pairs},
            {"timing_budget_ms", studyCase.grid->timingBudgetMs},
            {"reference_bytes", options.referenceBytes},
            {"reference_error_px", options.referenceErrorPx},
            {"draw_bytes", options.drawBytes},
            {"gl_backend", options.gl.backend},
            {"gl_device", options.gl.device},
            {"threads", options.threads},
            {"time_limit", options.timeLimitSeconds}};
}

json runCase(const json& request) {
    const fs::path sceneFile = request.at("scene").get<std::string>();
    const Scene scene = readScene(sceneFile, request.at("changes").get<SceneChanges>());
    requireFrameMemory(scene, FrameUse::Compared);
    const auto names = request.at("techniques").get<std::vector<std::string>>();
    const auto settings = parseSettings(request.at("settings").get<std::vector<std::string>>());
    const std::vector<ChosenTechnique> techniques = chosenTechniques(names, settings);

    ReferenceScene reference(scene, referenceOptions(request, techniques));
    const Frame referenceFrame = reference.render();
    const ReferenceSummary summary = summaryOf(reference.stats(), referenceFrame);

    TechniqueDrawer drawer(scene, workerOptions(request, sceneFile, scene), techniques);
    json result{{"techniques", json::array()}, {"pairs", json::array()}, {"fit", fitOf(scene)}};
    std::vector<Trial> trials;
    for (size_t i = 0; i < techniques.size(); ++i) {
        Trial& trial = trials.emplace_back(tryTechnique(techniques[i], drawer, &reference.microMeshes()));
        if (!trial.outcome.error) compareTrial(trial, referenceFrame, scene);
        if (trial.exitCode == kExitMachine) result["again"] = true;
        json results = resultsOf(scene, summary, {trial.outcome});
        result["techniques"].push_back({{"name", names[i]}, {"result", results["techniques"][0]}});
        result["reference"] = results["reference"];
    }
    for (const json& pair : request.at("pairs")) {
        const std::string first = pair.at(0), second = pair.at(1);
        result["pairs"].push_back({{"first", first},
                                   {"second", second},
                                   {"result", comparePair(trials[indexOf(names, first)],
                                                          trials[indexOf(names, second)], scene, summary)}});
    }
    return result;
}

std::string techniquesHash(const StudyGrid& grid) {
    ContentHash hash;
    const fs::path realtime = dataFolder() / "realtime";
    addFolder(hash, realtime / "shaders");
    addFolder(hash, realtime / "surfaces");
    for (const StudyTechnique& technique : grid.techniques) {
        hash.add(technique.name);
        addFolder(hash, techniqueFolder(parseTechnique(technique.name).search));
    }
    for (const std::string& setting : grid.settings)
        hash.add(setting);
    for (const StudyPair& pair : grid.pairs)
        hash.add(nameOf(grid, pair.first) + "\n" + nameOf(grid, pair.second));
    return hash.hexadecimal();
}

} // namespace plumbline
