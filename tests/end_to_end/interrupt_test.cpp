// Ctrl-C in the middle of the work: gone at once, nothing left behind.
#include "tests/end_to_end/program.h"

#include <chrono>
#include <csignal>
#include <thread>

namespace plumbline::test {
namespace {

class Interrupt : public EndToEnd {};

// 67 million micro-triangles take several seconds; half a second in, it is tessellating. A second is what a
// user is promised; a busy machine may need longer to clear a gigabyte away, and without the signal it would
// go on for longer than this waits.
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
