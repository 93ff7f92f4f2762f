#include "tests/end_to_end/program.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace plumbline::test {

namespace fs = std::filesystem;

const char* const kSmallScene = R"(purpose = "A small one for tests"
[camera]
position = [1.1, 2.0, 2.9]
target = [0, -0.12, 0]
fov_y_degrees = 40
width = 96
height = 72
[[light]]
name = "sun"
to_light = [-0.7, 0.6, 0.5]
[[height_map]]
name = "stone"
generate = { kind = "cobbles", size = 32, seed = 1 }
[[object]]
name = "torus"
shape = { kind = "torus", major = 1.0, minor = 0.4, segments = [12, 6] }
proxy_rate = 2
relief = { map = "stone", depth = 0.1, tile = [3, 2] }
[[object]]
name = "floor"
shape = { kind = "plane", width = 6, depth = 6, segments = [2, 2] }
translate = [0, -0.6, 0]
)";

namespace {

constexpr auto kTimeLimit = std::chrono::seconds(120);

std::vector<std::string> environmentWith(const std::map<std::string, std::string>& extra) {
    std::vector<std::string> variables;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text = *entry;
        if (!extra.contains(text.substr(0, text.find('=')))) variables.push_back(text);
    }
    for (const auto& [name, value] : extra)
        variables.push_back(name + "=" + value);
    return variables;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts)
        pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Waits for the process; kills it after the limit.
int waitFor(pid_t process) {
    const auto end = std::chrono::steady_clock::now() + kTimeLimit;
    int status = 0;
    while (waitpid(process, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > end) {
            ADD_FAILURE() << "the program hangs; it was stopped after 120 s";
            sendSignal(process, SIGKILL);
            waitpid(process, &status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return status;
}

} // namespace

namespace {

Running start(const char* program, std::vector<std::string> words, const fs::path& workingFolder,
              const std::map<std::string, std::string>& environment, bool ownGroup) {
    Running running;
    static std::atomic<int> started{0}; // runs in one folder, each with files of its own
    running.captured = workingFolder.string() + ".captured" + std::to_string(started++);
    fs::create_directories(running.captured);
    const std::string outFile = (running.captured / "out").string(),
                      errFile = (running.captured / "err").string();
    std::vector<std::string> variables = environmentWith(environment);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, workingFolder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, outFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    if (ownGroup) posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int failed = posix_spawn(&running.process, program, &actions, &attributes, pointersTo(words).data(),
                                   pointersTo(variables).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) {
        ADD_FAILURE() << "can't start " << program;
        running.process = -1;
    }
    return running;
}

} // namespace

Running startProgram(const std::vector<std::string>& arguments, const fs::path& workingFolder,
                     const std::map<std::string, std::string>& environment, bool ownGroup) {
    std::vector<std::string> words{PLUMBLINE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return start(PLUMBLINE_PROGRAM, words, workingFolder, environment, ownGroup);
}

Running startScript(const std::string& script, const fs::path& workingFolder) {
    return start("/bin/bash", {"bash", "-c", script}, workingFolder, {{"PLUMBLINE", PLUMBLINE_PROGRAM}},
                 false);
}

namespace {

struct ProcessState {
    char state = 'X'; // from /proc/PID/stat; X: no such process
    pid_t parent = 0;
};

ProcessState stateOf(const std::string& process) {
    std::ifstream stream("/proc/" + process + "/stat");
    std::string text;
    std::getline(stream, text);
    const size_t nameEnd = text.rfind(')'); // the name before it may contain any characters
    if (nameEnd == std::string::npos) return {};
    ProcessState result;
    std::istringstream(text.substr(nameEnd + 1)) >> result.state >> result.parent;
    return result;
}

} // namespace

int sendSignal(pid_t process, int signal) {
    if (process > 1) return kill(process, signal);
    errno = ESRCH;
    return -1;
}

int sendSignalToGroup(pid_t leader, int signal) {
    if (leader > 1) return kill(-leader, signal);
    errno = ESRCH;
    return -1;
}

bool isGone(pid_t process) {
    const std::string name = std::to_string(process);
    const char state = stateOf(name).state;
    if (state != 'Z') return state == 'X';
    std::error_code error; // its main thread can be a zombie while others are running
    const auto threads = std::distance(fs::directory_iterator("/proc/" + name + "/task", error), {});
    return error || threads <= 1;
}

std::vector<pid_t> childrenOf(pid_t process) {
    std::vector<pid_t> children;
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        if (std::all_of(name.begin(), name.end(), ::isdigit) && stateOf(name).parent == process)
            children.push_back(std::stoi(name));
    }
    return children;
}

bool waitUntil(const std::function<bool()>& condition, double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

Outcome finish(const Running& running) {
    Outcome outcome;
    if (running.process < 0) return outcome;
    const int status = waitFor(running.process);
    if (WIFEXITED(status))
        outcome.exitCode = WEXITSTATUS(status);
    else
        outcome.signal = WTERMSIG(status);
    outcome.out = readFile(running.captured / "out");
    outcome.err = readFile(running.captured / "err");
    fs::remove_all(running.captured);
    return outcome;
}

Outcome runProgram(const std::vector<std::string>& arguments, const fs::path& workingFolder,
                   const std::map<std::string, std::string>& environment) {
    return finish(startProgram(arguments, workingFolder, environment));
}

std::vector<std::string> filesBelow(const fs::path& folder) {
    std::vector<std::string> files;
    if (!fs::is_directory(folder)) return files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (std::error_code loop; entry.is_regular_file(loop))
            files.push_back(fs::relative(entry.path(), folder).string());
    std::sort(files.begin(), files.end());
    return files;
}

std::string withLine(const std::string& text, const std::string& line, const std::string& replacement) {
    const size_t at = text.find(line);
    if (at == std::string::npos || text.find(line, at + 1) != std::string::npos) {
        ADD_FAILURE() << "not there exactly once: " << line;
        return text;
    }
    return text.substr(0, at) + replacement + text.substr(at + line.size());
}

void expectRefusal(const Outcome& outcome, int exitCode, const std::string& part) {
    EXPECT_EQ(outcome.signal, 0) << "crashed";
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err << "has no " << part;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

void expectOnlyTheCertificate(const std::string& err) {
    EXPECT_TRUE(err.starts_with("certificate: ")) << err;
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
}

fs::path EndToEnd::writeSmallScene() const {
    writeFile(folder_ / "small.toml", kSmallScene);
    return folder_ / "small.toml";
}

} // namespace plumbline::test
