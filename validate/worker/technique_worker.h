// Draws techniques in a process of their own, so that a shader that loops for ever, or a driver that crashes
// over it, costs that one technique and not the run: the process is killed, and the next technique gets a new
// one.
//
// llvmpipe runs shaders on threads of the process that draws, and nothing but its end stops them. The process
// serves technique after technique: starting it takes up to half a second.
#pragma once

#include "realtime/realtime.h"

#include <filesystem>

namespace plumbline {

inline constexpr int kDefaultTimeLimitSeconds = 60;
/// The command by which the program starts itself to draw; --help doesn't list it.
inline constexpr const char* kDrawWorkerCommand = "draw-worker";

struct WorkerOptions {
    std::filesystem::path sceneFile;
    std::vector<std::string> sceneChanges; // Scene::changes
    std::string sceneHash;                 // Scene::hash of the file with them
    GlOptions gl;
    int threads = 0; // --threads; 0: all
    int timeLimitSeconds = kDefaultTimeLimitSeconds;
    std::filesystem::path program =
        "/proc/self/exe"; // plumbline itself, also where its file was replaced meanwhile
};

class TechniqueWorker {
  public:
    /// Starts the process but doesn't wait for it. Linux ends it with the *thread* that runs this: use one
    /// that stays.
    explicit TechniqueWorker(const WorkerOptions& options);
    ~TechniqueWorker();

    /// Waits until it has read the scene and started OpenGL. Throws what readScene and RealtimeRenderer
    /// throw.
    void waitUntilReady();

    /// As RealtimeRenderer::render, to the byte. The process resolves the technique's request in its turn.
    /// Throws what that throws; InputError if compiling and drawing take longer than the limit; MachineError
    /// if the process ends. Time spent on maps before that, or stopped by Ctrl-Z, doesn't count.
    TechniqueResult render(const Technique& technique);

  private:
    struct Connection;
    void start();
    /// `drawing`: whether the technique's time runs, kept up to date also where this throws.
    TechniqueResult awaitResult(const std::string& technique, bool& drawing);

    WorkerOptions options_;
    std::unique_ptr<Connection> connection_; // null: not started since the last one was stopped
};

} // namespace plumbline
