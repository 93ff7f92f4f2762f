// Ctrl-C during work: the program ends immediately and leaves no files.
#include "tests/end_to_end/program.h"

#include <chrono>
#include <csignal>
#include <thread>

namespace plumbline::test {
namespace {

class Interrupt : public EndToEnd {};

// 67 million micro-triangles take several seconds; after half a second it is tessellating. Users are promised
// an end within a second. A busy machine may need longer to release a gigabyte, so the test waits longer, but
// less than the run would take without the signal.
TEST_F(Interrupt, DuringTessellation_EndsWithoutFile) {
    const Running running = startProgram(
        {"reference", "stone_torus", "--rate", "512", "--memory", "4G", "-o", "out/frame.exr"}, folder_);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ASSERT_FALSE(isGone(running.process)) << "ended before it was interrupted";
    ASSERT_EQ(sendSignal(running.process, SIGINT), 0);
    EXPECT_TRUE(waitUntil([&] { return isGone(running.process); }, 2))
        << "still there two seconds after SIGINT";
    EXPECT_EQ(finish(running).signal, SIGINT);
    EXPECT_TRUE(filesBelow(folder_).empty()) << filesBelow(folder_).front();
}

} // namespace
} // namespace plumbline::test
