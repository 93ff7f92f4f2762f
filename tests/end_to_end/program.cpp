#include "program.h"

#include <algorithm>
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

/// Waits for the process; kills it at the limit.
int waitFor(pid_t process) {
    const auto end = std::chrono::steady_clock::now() + kTimeLimit;
    int status = 0;
    while (waitpid(process, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > end) {
            ADD_FAILURE() << "the program hangs; it was stopped after 120 s";
            kill(process, SIGKILL);
            waitpid(process, &status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return status;
}

} // namespace

Outcome runProgram(const std::vector<std::string>& arguments, const fs::path& workingFolder,
                   const std::map<std::string, std::string>& environment) {
    // Outside the working folder, so that tests can list what the program left there.
    const fs::path captured = workingFolder.string() + ".captured";
    fs::create_directories(captured);
    const std::string outFile = (captured / "out").string(), errFile = (captured / "err").string();
    std::vector<std::string> words{PLUMBLINE_PROGRAM}, variables = environmentWith(environment);
    words.insert(words.end(), arguments.begin(), arguments.end());

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, workingFolder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, outFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    pid_t process = 0;
    const int failed = posix_spawn(&process, PLUMBLINE_PROGRAM, &actions, nullptr, pointersTo(words).data(),
                                   pointersTo(variables).data());
    posix_spawn_file_actions_destroy(&actions);
    Outcome outcome;
    if (failed != 0) {
        ADD_FAILURE() << "can't start " << PLUMBLINE_PROGRAM;
        return outcome;
    }
    const int status = waitFor(process);
    if (WIFEXITED(status))
        outcome.exitCode = WEXITSTATUS(status);
    else
        outcome.signal = WTERMSIG(status);
    outcome.out = readFile(outFile);
    outcome.err = readFile(errFile);
    fs::remove_all(captured);
    return outcome;
}

std::string readFile(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    EXPECT_TRUE(stream) << file;
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void writeFile(const fs::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    EXPECT_TRUE(stream.flush()) << file;
}

std::vector<std::string> filesBelow(const fs::path& folder) {
    std::vector<std::string> files;
    if (!fs::is_directory(folder)) return files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder).string());
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

void expectOnlyTheCertificate(const std::string& err) {
    EXPECT_TRUE(err.starts_with("certificate: ")) << err;
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
}

void EndToEnd::SetUp() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "_" + test->name();
    std::replace(name.begin(), name.end(), '/', '_');
    folder_ = fs::temp_directory_path() / ("plumbline_" + name + "_" + std::to_string(getpid()));
    fs::create_directories(folder_);
}

void EndToEnd::TearDown() {
    fs::remove_all(folder_);
}

fs::path EndToEnd::writeSmallScene() const {
    writeFile(folder_ / "small.toml", kSmallScene);
    return folder_ / "small.toml";
}

} // namespace plumbline::test
