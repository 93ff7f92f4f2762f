#include "validate/cli/case_pool.h"

#include "scenes/core/error.h"
#include "validate/worker/serve_parent.h"
#include "validate/worker/worker_process.h"
#include "validate/worker/worker_protocol.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <deque>
#include <exception>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

namespace plumbline {
namespace {

using nlohmann::json;

/// Before a case that another run is computing is looked at again.
constexpr std::chrono::milliseconds kBetweenLooks(200);

/// "again": a later run is to try it again, for the reason may have gone.
json failure(const std::string& text, bool again) {
    json outcome{{"error", text}};
    if (again) outcome["again"] = true;
    return outcome;
}

json replyOf(const StudyCase& studyCase, const CaseOptions& options) {
    WorkerProcess process("/proc/self/exe", kStudyCaseCommand, options.threads);
    try {
        process.socket.send(caseRequest(studyCase, options));
        const json reply = process.socket.receive();
        if (const std::exception_ptr error = errorOf(reply)) std::rethrow_exception(error);
        return reply.at("result");
    } catch (const InputError& error) {
        // Stays wrong until someone changes it, and then the case has another name.
        return failure(error.what(), false);
    } catch (const ConnectionLost&) {
        return failure(fmt::format("its process ended ({})", process.howItEnded()), true);
    } catch (const std::exception& error) {
        return failure(error.what(), true);
    }
}

json outcomeOf(const StudyCase& studyCase, const CaseOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    json outcome = replyOf(studyCase, options);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    outcome["seconds"] = spent.count();
    outcome["scene"] = studyCase.scene;
    outcome["values"] = studyCase.values;
    outcome["changes"] = studyCase.changes;
    if (!outcome.contains("error")) outcome["error"] = nullptr;
    return outcome;
}

/// Cases in order; those that another run is computing go to the end, for it may not finish them.
class CaseQueue {
  public:
    explicit CaseQueue(const std::vector<StudyCase>& cases) {
        for (const StudyCase& each : cases)
            waiting_.push_back(&each);
    }
    /// Null: none is left.
    const StudyCase* next() {
        std::unique_lock lock(mutex_);
        if (waiting_.empty()) return nullptr;
        const StudyCase* first = waiting_.front();
        waiting_.pop_front();
        const bool taken = putBack_.erase(first) > 0;
        lock.unlock();
        if (taken) std::this_thread::sleep_for(kBetweenLooks);
        return first;
    }
    void putBack(const StudyCase* taken) {
        const std::lock_guard lock(mutex_);
        if (stopped_) return;
        waiting_.push_back(taken);
        putBack_.insert(taken);
    }
    void stop() {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
        stopped_ = true;
    }

  private:
    std::mutex mutex_;
    std::deque<const StudyCase*> waiting_;
    std::set<const StudyCase*> putBack_; // of those waiting
    bool stopped_ = false;
};

/// The case's outcome, computed and stored unless another run did that first; nullopt while it does.
std::optional<FinishedCase> finish(const StudyFolder& folder, const StudyCase& studyCase,
                                   const CaseOptions& options) {
    const std::optional<FileLock> claim = folder.claim(studyCase);
    if (!claim) return std::nullopt;
    if (std::optional<json> stored = folder.outcomeOf(studyCase))
        return FinishedCase{std::move(*stored), false};
    FinishedCase finished{outcomeOf(studyCase, options), true};
    folder.store(studyCase, finished.outcome);
    return finished;
}

} // namespace

void runCases(const StudyFolder& folder, const std::vector<StudyCase>& cases, int jobs,
              const CaseOptions& options, const CaseDone& done) {
    CaseQueue queue(cases);
    std::mutex mutex;
    std::exception_ptr problem;
    // Linux ends a process with the thread that started it: each stays until its processes are done.
    const auto work = [&] {
        while (const StudyCase* next = queue.next()) {
            try {
                const std::optional<FinishedCase> finished = finish(folder, *next, options);
                if (!finished) {
                    queue.putBack(next);
                    continue;
                }
                const std::lock_guard lock(mutex);
                if (!problem) done(*next, *finished);
            } catch (...) {
                const std::lock_guard lock(mutex);
                problem = std::current_exception();
                queue.stop();
            }
        }
    };
    std::vector<std::thread> threads;
    try {
        for (int i = 0; i < jobs; ++i)
            threads.emplace_back(work);
    } catch (const std::system_error&) { // no more threads: those there are do
        if (threads.empty()) throw;
    }
    for (std::thread& thread : threads)
        thread.join();
    if (problem) std::rethrow_exception(problem);
}

int serveStudyCase(int parent) {
    return serveParent(parent, kStudyCaseCommand, [](const MessageSocket& socket) {
        socket.send(json{{"result", runCase(socket.receive())}});
    });
}

} // namespace plumbline
