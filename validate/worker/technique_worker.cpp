#include "validate/worker/technique_worker.h"

#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"
#include "validate/worker/worker_process.h"
#include "validate/worker/worker_protocol.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>

namespace plumbline {
namespace {

using std::chrono::milliseconds;

/// Time is counted in slices. At most one is counted while this process is stopped (Ctrl-Z).
constexpr milliseconds kSlice(100);
/// Time that a process gets at its end to write its shader caches.
constexpr milliseconds kShutdown(1000);

/// Waits for a message and subtracts the time from `left`. Returns false if no time is left.
bool waitWithin(const MessageSocket& socket, milliseconds& left) {
    while (left.count() > 0) {
        const auto start = std::chrono::steady_clock::now();
        if (socket.waitFor(std::min(left, kSlice))) {
            const auto spent = std::chrono::steady_clock::now() - start;
            left -= std::min(std::chrono::duration_cast<milliseconds>(spent), kSlice);
            return true;
        }
        left -= kSlice;
    }
    return false;
}

InputError tooSlow(const std::string& technique, int limitSeconds) {
    return {technique, fmt::format("not finished after {} s and stopped", limitSeconds),
            "a search whose loops terminate", "--time-limit SECONDS raises the limit"};
}

/// Whether a process that ended did so for lack of memory. Drivers and compilers that are refused some crash
/// in many ways, but not far below the limit unless they ask for very much at once.
bool ranOutOfMemory(const ChildProcess& process, uint64_t limitBytes) {
    constexpr double kNearLimit = 0.75; // the limit also counts what was never touched
    return process.exitCode() == kOutOfMemoryExit ||
           static_cast<double>(process.peakBytes()) >= kNearLimit * static_cast<double>(limitBytes);
}

MachineError endedWhile(const std::string& where, bool drawing, WorkerProcess& worker, uint64_t memoryBytes) {
    const std::string how = worker.howItEnded();
    if (ranOutOfMemory(worker.process, memoryBytes))
        return {where,
                fmt::format("its process ran out of memory ({}; its limit is {:.1f} GB)", how,
                            static_cast<double>(memoryBytes) / 1e9),
                "a shader that compiles and draws with less", "--draw-memory SIZE raises the limit"};
    if (worker.process.signal() == SIGKILL)
        return {where, fmt::format("its process was killed ({})", how), "", "memory may have run out"};
    return {where,
            fmt::format("{} the process ({})", drawing ? "the OpenGL driver ended" : "something ended", how)};
}

} // namespace

struct TechniqueWorker::Connection : WorkerProcess {
    using WorkerProcess::WorkerProcess;
    bool ready = false;
    uint64_t memoryBytes = 0; // its limit
};

TechniqueWorker::TechniqueWorker(const WorkerOptions& options) : options_(options) {
    start();
}

TechniqueWorker::~TechniqueWorker() {
    if (!connection_) return;
    connection_->socket = MessageSocket(-1); // the process ends when the socket is closed
    connection_->process.waitForEnd(kShutdown);
}

void TechniqueWorker::start() {
    connection_ = std::make_unique<Connection>(options_.program, kDrawWorkerCommand, options_.threads);
    connection_->memoryBytes =
        options_.memoryBytes > 0
            ? options_.memoryBytes
            : static_cast<uint64_t>(kMemoryShare * static_cast<double>(freeMemoryBytes()));
    try {
        connection_->socket.send(
            toJson(WorkerSetup{options_.sceneFile, options_.sceneChanges, options_.sceneHash, options_.gl,
                               connection_->memoryBytes}));
    } catch (const ConnectionLost&) {
        // It has already ended; waitUntilReady reports how.
    }
}

void TechniqueWorker::waitUntilReady() {
    // If it ended after its last technique, the next one isn't affected.
    if (connection_ && connection_->ready && connection_->process.waitForEnd(milliseconds(0)))
        connection_.reset();
    if (!connection_) start();
    if (connection_->ready) return;
    try {
        const WorkerReply reply = receiveReply(connection_->socket, options_.frameSize);
        if (reply.error) std::rethrow_exception(reply.error);
        connection_->ready = true;
    } catch (const ConnectionLost&) {
        const MachineError error =
            endedWhile("starting OpenGL", true, *connection_, connection_->memoryBytes);
        connection_.reset();
        throw error;
    } catch (...) {
        connection_.reset();
        throw;
    }
}

TechniqueResult TechniqueWorker::render(const Technique& technique) {
    waitUntilReady();
    bool drawing = false;
    try {
        connection_->socket.send(toJson(technique.request()));
        return awaitResult(technique.name(), drawing);
    } catch (const InputError&) {
        throw; // an error of the technique; the process is fine
    } catch (const ConnectionLost&) {
        const MachineError error =
            endedWhile(technique.name(), drawing, *connection_, connection_->memoryBytes);
        connection_.reset();
        throw error;
    } catch (...) {
        connection_
            .reset(); // the next technique needs a new process, because this one may have lost its context
        throw;
    }
}

TechniqueResult TechniqueWorker::awaitResult(const std::string& technique, bool& drawing) {
    milliseconds left = std::chrono::seconds(options_.timeLimitSeconds);
    for (;;) {
        if (drawing && !waitWithin(connection_->socket, left)) {
            connection_.reset();
            throw tooSlow(technique, options_.timeLimitSeconds);
        }
        WorkerReply reply = receiveReply(connection_->socket, options_.frameSize);
        if (reply.error) std::rethrow_exception(reply.error);
        if (reply.result) return std::move(*reply.result);
        drawing = reply.phase == kPhaseDrawing;
    }
}

} // namespace plumbline
