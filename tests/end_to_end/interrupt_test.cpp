// Ctrl-C in the middle of the work: gone at once, nothing left behind.
#include "program.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace plumbline::test {
namespace {

/// The program started in a folder, with stdout and stderr thrown away.
pid_t start(const std::filesystem::path& folder, const std::vector<std::string>& arguments) {
    std::vector<char*> argv{const_cast<char*>(PLUMBLINE_PROGRAM)};
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        if (chdir(folder.c_str()) == 0) execv(argv[0], argv.data());
        _exit(127);
    }
    return child;
}

class Interrupt : public EndToEnd {};

// 67 million micro-triangles take several seconds; half a second in, it is tessellating. A second is what a user is promised; a busy
// machine may need longer to clear a gigabyte away, and without the signal it would go on for longer than this waits.
TEST_F(Interrupt, TessellationEndsAtOnceAndLeavesNoFile) {
    const pid_t child = start(
        folder_, {"reference", "stone_torus", "--rate", "512", "--memory", "4G", "-o", "out/frame.exr"});
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, WNOHANG), 0) << "ended before it was interrupted";
    ASSERT_EQ(kill(child, SIGINT), 0);
    bool ended = false;
    for (int i = 0; i < 200 && !ended; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ended = waitpid(child, &status, WNOHANG) == child;
    }
    if (!ended) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
    }
    EXPECT_TRUE(ended) << "still there two seconds after SIGINT";
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
    EXPECT_TRUE(filesBelow(folder_).empty()) << filesBelow(folder_).front();
}

} // namespace
} // namespace plumbline::test
