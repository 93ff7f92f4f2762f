// Runs the built program as a user would: arguments in; exit code, stdout and stderr out.
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
    int exitCode = -1; // -1 if a signal ended it
    int signal = 0;    // the signal that ended it; SIGKILL after the time limit
    std::string out, err;
};

/// A run in the background of the test. `ownGroup`: in a separate process group, as a shell starts it; Ctrl-C
/// sends a signal to the whole group. Its output is outside the working folder, so that tests can list the
/// files left there.
struct Running {
    pid_t process = -1;
    std::filesystem::path captured;
};
Running startProgram(const std::vector<std::string>& arguments, const std::filesystem::path& workingFolder,
                     const std::map<std::string, std::string>& environment = {}, bool ownGroup = false);
/// The same for a script of the shell, which finds the program's path in $PLUMBLINE: limits and redirections.
Running startScript(const std::string& script, const std::filesystem::path& workingFolder);
/// Whether a process has ended, even if its parent hasn't waited for it yet.
bool isGone(pid_t process);
/// As kill(2), for one process or the group it leads. Refuses numbers that can't be a process started by a
/// test: -1 and 0 would signal many processes.
int sendSignal(pid_t process, int signal);
int sendSignalToGroup(pid_t leader, int signal);
/// The child processes of `process`.
std::vector<pid_t> childrenOf(pid_t process);
/// Polls the condition; returns false if it isn't met within that time.
bool waitUntil(const std::function<bool()>& condition, double seconds);
/// Waits for its end; kills it after two minutes.
Outcome finish(const Running& running);

/// `environment`: variables in addition to those of this process. The run is killed after two minutes,
/// because none takes longer than seconds unless it hangs.
Outcome runProgram(const std::vector<std::string>& arguments, const std::filesystem::path& workingFolder,
                   const std::map<std::string, std::string>& environment = {});

/// Every regular file below a folder, as relative paths, sorted.
std::vector<std::string> filesBelow(const std::filesystem::path& folder);

/// Limits of the address space can't be tested then: the sanitizer reserves terabytes of it.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kAddressSanitizer = true;
#else
inline constexpr bool kAddressSanitizer = false;
#endif

/// Whether the program is built with OpenGL.
inline constexpr bool kProgramDraws = PLUMBLINE_PROGRAM_DRAWS;

/// A separate folder for each test, removed after it.
class EndToEnd : public ::testing::Test {
  private:
    TemporaryFolder temporary_;

  protected:
    Outcome run(const std::vector<std::string>& arguments,
                const std::map<std::string, std::string>& environment = {}) const {
        return runProgram(arguments, folder_, environment);
    }
    Outcome runScript(const std::string& script) const { return finish(startScript(script, folder_)); }
    /// Writes small.toml: a torus with a relief and an object without, 96 x 72 pixels, one light.
    std::filesystem::path writeSmallScene() const;

    const std::filesystem::path folder_ = temporary_.path();
};

/// A scene's text with one line replaced; fails the test unless it contains `line` exactly once.
std::string withLine(const std::string& text, const std::string& line, const std::string& replacement);

/// Expects an error: the exit code, one line on stderr that contains `part`, nothing on stdout.
void expectRefusal(const Outcome& outcome, int exitCode, const std::string& part);

/// Expects the stderr of a run of the reference without warnings: one line, the certificate.
void expectOnlyTheCertificate(const std::string& err);

extern const char* const kSmallScene;

} // namespace plumbline::test
