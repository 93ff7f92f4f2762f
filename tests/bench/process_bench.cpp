#include "tests/bench/process_bench.h"

#include <algorithm>
#include <chrono>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace plumbline {

namespace {

struct OneRun {
    int exitCode;
    double wallSeconds, peakMegabytes;
};

OneRun runOnce(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        execv(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, wall.count(),
            static_cast<double>(usage.ru_maxrss) / 1024};
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

} // namespace

ProcessResult runProcess(const std::vector<std::string>& command, int runs) {
    ProcessResult result;
    result.runs = runs;
    result.exitCode = runOnce(command).exitCode;
    std::vector<double> walls, peaks;
    for (int i = 0; i < runs && result.exitCode == 0; ++i) {
        const OneRun run = runOnce(command);
        result.exitCode = run.exitCode;
        walls.push_back(run.wallSeconds);
        peaks.push_back(run.peakMegabytes);
    }
    if (result.exitCode != 0) return result;
    result.wallSeconds = median(walls);
    result.peakMegabytes = median(peaks);
    return result;
}

} // namespace plumbline
