// Draws techniques in a separate process, so that a shader that loops forever, or a driver that crashes,
// fails that one technique and not the run: the process is killed, and the next technique gets a new one.
//
// llvmpipe runs shaders on threads of the drawing process, and only ending the process stops them. The
// process is reused for the next technique, because starting it takes up to half a second.
#pragma once

#include "realtime/realtime.h"

#include <filesystem>

namespace plumbline {

inline constexpr int kDefaultTimeLimitSeconds = 60;
/// The rest is for the run itself and for the other programs on the machine.
inline constexpr double kMemoryShare = 0.75;
/// The command with which the program starts itself to draw; --help doesn't list it.
inline constexpr const char* kDrawWorkerCommand = "draw-worker";

struct WorkerOptions {
    std::filesystem::path sceneFile;
    std::vector<std::string> sceneChanges; // Scene::changes
    std::string sceneHash;                 // Scene::hash of the file with them
    Vec2i frameSize{0};                    // of the scene's camera
    GlOptions gl;
    int threads = 0; // --threads; 0: all
    int timeLimitSeconds = kDefaultTimeLimitSeconds;
    uint64_t memoryBytes = 0; // limit of the process; 0: kMemoryShare of what is free when it starts
    std::filesystem::path program = "/proc/self/exe"; // this program, even if its file was replaced meanwhile
};

class TechniqueWorker {
  public:
    /// Starts the process but doesn't wait for it. Linux ends it with the *thread* that runs this, so that
    /// thread must outlive the worker.
    explicit TechniqueWorker(const WorkerOptions& options);
    ~TechniqueWorker();

    /// Waits until it has read the scene and started OpenGL. Throws what readScene and RealtimeRenderer
    /// throw.
    void waitUntilReady();

    /// The result is that of RealtimeRenderer::render, to the byte. The process resolves the technique's
    /// request itself. Throws what render throws; InputError if compiling and drawing take longer than the
    /// limit; MachineError if the process ends, which it does above its limit of memory. Time spent on baking
    /// maps before that, or stopped by Ctrl-Z, doesn't count.
    TechniqueResult render(const Technique& technique);

  private:
    struct Connection;
    void start();
    /// `drawing`: set to whether the time of the technique is running, also if this throws.
    TechniqueResult awaitResult(const std::string& technique, bool& drawing);

    WorkerOptions options_;
    std::unique_ptr<Connection> connection_; // null: no process is running
};

} // namespace plumbline
