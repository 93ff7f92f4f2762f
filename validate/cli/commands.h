// The commands of the program, one .cpp each: arguments in, exit code out. main.cpp reads the command line.
//
// All throw InputError or MachineError; main.cpp turns those into one line on stderr and exit code 2 or 3.
// Results go to stdout, progress to stderr when that is a terminal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

inline constexpr int kExitDone = 0;
inline constexpr int kExitThreshold = 1; // figures aren't as good as they were to be
inline constexpr int kExitBadInput = 2;  // bad input or usage; also: a technique failed on its own files
inline constexpr int kExitMachine = 3;   // this machine lacks something
inline constexpr int kExitInternal = 70; // a fault of the program itself (EX_SOFTWARE of sysexits.h)
inline constexpr const char* kDefaultScene = "small_torus";
inline constexpr int kDefaultTimeLimitSeconds = 60, kLongestTimeLimitSeconds = 86400;
/// By this command the program draws techniques for itself (worker/); --help doesn't list it.
inline constexpr const char* kDrawWorkerCommand = "draw-worker";
/// Likewise, for a case of a study.
inline constexpr const char* kStudyCaseCommand = "study-case";

struct ReferenceArguments {
    std::string scene = kDefaultScene;     // path or library name
    std::vector<std::string> sceneChanges; // PATH=VALUE, scenes/scene_file/scene_file.h
    std::optional<std::filesystem::path> output;
    int rate = 0;                                              // segments per control edge; 0: chosen
    std::optional<std::string> memory;                         // "256M"; nullopt: the reference's own default
    std::string base = "limit";                                // or "proxy"; for validate also "both"
    std::optional<std::string> errorPx;                        // "0.05"; nullopt: the reference's own default
    std::optional<std::filesystem::path> meshFile, cameraFile; // of `reference` only: .ply or .obj, .json
};

struct RealtimeArguments {
    std::string scene = kDefaultScene;
    std::vector<std::string> sceneChanges;
    std::vector<std::string> techniques;
    std::vector<std::string> settings; // key=value, for all of them
    std::optional<std::filesystem::path> output;
    std::string glBackend = "auto";
    int glDevice = -1;
    int timeLimitSeconds = kDefaultTimeLimitSeconds; // a technique
    int threads = 0;                                 // 0: as many as the machine has
};

struct ReportArguments {
    bool singleFile = false; // index.html alone
    bool plain = false;      // without scripts, though the program may hold them
};

struct ValidateArguments {
    ReferenceArguments reference;
    RealtimeArguments realtime;
    std::optional<std::filesystem::path> output; // folder
    ReportArguments report;
    std::vector<std::string> require; // "silhouette.iou >= 0.99"
};

struct CompareArguments {
    std::filesystem::path reference, test;
    std::vector<std::string> channelMap;         // THEIRS=OURS, validate/compare/foreign_frame.h
    std::optional<std::filesystem::path> output; // folder
    bool json = false;
    ReportArguments report;
    std::vector<std::string> require; // as for validate
};

inline constexpr uint64_t kDefaultCheckRays = 1'000'000;

struct BakeArguments {
    std::string map;  // a picture's path, or SCENE#NAME: a map of a scene
    std::string kind; // name in bakeKinds()
    std::optional<std::string> stores,
        wrap; // of a picture: "depth" or "height"; "repeat,clamp" along s and t
    std::optional<std::string> depth, tileSize; // world units; "2,1.5"
    std::optional<int> slices;
    std::optional<std::filesystem::path> output; // a picture
    bool check = false;                          // of a cone map: rays that leap over the relief
    std::optional<uint64_t> rays;                // so many
};

struct StudyArguments {
    std::string study;                           // path, or a name in validate/studies/
    std::optional<std::filesystem::path> output; // folder
    int jobs = 0;                                // cases at a time; 0: as many as there are cores
    int threads = 0;                             // of all of them together; 0: all cores
    bool yes = false;                            // also very many cases
    std::string glBackend = "auto";
    int glDevice = -1;
};

struct NewArguments {
    std::filesystem::path mesh, height; // OBJ; a picture
    std::optional<std::string> depth, tile, scheme,
        wrap;                      // world units; "4,2"; of scene files; "repeat,clamp"
    std::string stores = "height"; // or "depth"
    std::filesystem::path output;  // the scene file
    bool force = false;            // also if it exists
};

struct HistoryArguments {
    std::filesystem::path file;
    std::vector<std::filesystem::path> results; // results.json, oldest first
    std::optional<std::string> label;           // of all of them
    std::vector<std::string> tolerances;        // FIGURE=AMOUNT, history_moves.h
    bool dryRun = false;                        // the file stays as it is
};

int runNew(const NewArguments& arguments);
/// kExitThreshold if a figure is worse than tolerated.
int runHistory(const HistoryArguments& arguments);
int runValidate(const ValidateArguments& arguments);
int runReference(const ReferenceArguments& arguments);
int runRealtime(const RealtimeArguments& arguments);
int runCompare(const CompareArguments& arguments);
int runBake(const BakeArguments& arguments);
/// `what`: scenes, techniques, surfaces, metrics or bakes.
int runList(const std::string& what);
int runDoctor();
int runStudy(const StudyArguments& arguments);
int runStudyReport(const StudyArguments& arguments);
/// `parent`: as for runDrawWorker.
int runStudyCase(int parent);
/// `parent`: the process that started this one and is served by it.
int runDrawWorker(int parent);

} // namespace plumbline
