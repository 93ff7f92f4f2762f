#include "validate/cli/case_pool.h"

#include "scenes/core/error.h"
#include "validate/worker/serve_parent.h"
#include "validate/worker/worker_process.h"
#include "validate/worker/worker_protocol.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

namespace plumbline {
namespace {

using nlohmann::json;

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

} // namespace

void runCases(const std::vector<StudyCase>& cases, int jobs, const CaseOptions& options,
              const CaseDone& done) {
    std::atomic<size_t> next{0};
    std::mutex mutex;
    std::exception_ptr problem;
    // Linux ends a process with the thread that started it: each stays until its processes are done.
    const auto work = [&] {
        for (size_t i = next++; i < cases.size(); i = next++) {
            try {
                const json outcome = outcomeOf(cases[i], options);
                const std::lock_guard lock(mutex);
                if (!problem) done(cases[i], outcome);
            } catch (...) {
                const std::lock_guard lock(mutex);
                problem = std::current_exception();
                next = cases.size();
            }
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < jobs; ++i)
        threads.emplace_back(work);
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
