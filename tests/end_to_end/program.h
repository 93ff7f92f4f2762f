// Runs the built program the way a person would: arguments in; exit code, stdout and stderr out.
#pragma once

#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace plumbline::test {

struct Outcome {
    int exitCode = -1; // -1: ended by a signal
    int signal = 0;    // that signal; SIGKILL after the time limit
    std::string out, err;
};

/// A run that goes on beside the test. `ownGroup`: in a process group of its own, as a shell starts it;
/// Ctrl-C is a signal to all of that. Its output is outside the working folder, so that tests can list what
/// it left there.
struct Running {
    pid_t process = -1;
    std::filesystem::path captured;
};
Running startProgram(const std::vector<std::string>& arguments, const std::filesystem::path& workingFolder,
                     const std::map<std::string, std::string>& environment = {}, bool ownGroup = false);
/// Whether a process is no more, or only waits for its parent to take notice.
bool isGone(pid_t process);
/// As kill(2), for one process, or the group it leads. Refuses what isn't the number of a process a test may
/// have started: -1 and 0 would be everybody's.
int sendSignal(pid_t process, int signal);
int sendSignalToGroup(pid_t leader, int signal);
/// Processes that `process` started.
std::vector<pid_t> childrenOf(pid_t process);
/// Asks again and again; false: not within that time.
bool waitUntil(const std::function<bool()>& condition, double seconds);
/// Waits for its end; kills it after two minutes.
Outcome finish(const Running& running);

/// `environment`: variables on top of this process's own. Ended after two minutes: nothing here takes longer
/// than seconds, so that is a hang.
Outcome runProgram(const std::vector<std::string>& arguments, const std::filesystem::path& workingFolder,
                   const std::map<std::string, std::string>& environment = {});

/// Every regular file below a folder, as relative paths, sorted.
std::vector<std::string> filesBelow(const std::filesystem::path& folder);

/// A folder of its own for each test, removed after it.
class EndToEnd : public ::testing::Test {
  private:
    TemporaryFolder temporary_;

  protected:
    Outcome run(const std::vector<std::string>& arguments,
                const std::map<std::string, std::string>& environment = {}) const {
        return runProgram(arguments, folder_, environment);
    }
    /// Writes small.toml: a torus with a relief and one without, 96 x 72 pixels, one light.
    std::filesystem::path writeSmallScene() const;

    const std::filesystem::path folder_ = temporary_.path();
};

/// A scene's text with one line replaced; fails the test if `line` isn't in it exactly once.
std::string withLine(const std::string& text, const std::string& line, const std::string& replacement);

/// What every refusal looks like: the exit code, one line on stderr that has `part`, nothing on stdout.
void expectRefusal(const Outcome& outcome, int exitCode, const std::string& part);

/// stderr of a run that drew a reference and had nothing to complain of: one line, the certificate.
void expectOnlyTheCertificate(const std::string& err);

extern const char* const kSmallScene;

} // namespace plumbline::test
