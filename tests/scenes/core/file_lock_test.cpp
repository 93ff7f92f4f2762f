#include "scenes/core/file_lock.h"
#include "scenes/core/replace_file.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace plumbline {
namespace {

TEST(FileLock, Held_RefusesAnother) {
    const TemporaryFolder folder;
    {
        const auto held = FileLock::acquire(folder.path(), "a");
        ASSERT_TRUE(held);
        EXPECT_FALSE(FileLock::acquire(folder.path(), "a"));
        EXPECT_TRUE(FileLock::acquire(folder.path(), "b"));
        EXPECT_TRUE(FileLock::acquire(folder.path(), std::string(10'000, 'n')));
    }
    EXPECT_TRUE(FileLock::acquire(folder.path(), "a"));
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(FileLock, Shared_RefusesExclusiveUntilTheLastEnds) {
    const TemporaryFolder folder;
    auto first = FileLock::acquire(folder.path(), "a", LockKind::Shared);
    auto second = FileLock::acquire(folder.path(), "a", LockKind::Shared);
    ASSERT_TRUE(first && second);
    EXPECT_FALSE(FileLock::acquire(folder.path(), "a"));
    first.reset();
    EXPECT_FALSE(FileLock::acquire(folder.path(), "a"));
    second.reset();
    EXPECT_EQ(folder.fileCount(), 0u);
    const auto exclusive = FileLock::acquire(folder.path(), "a");
    EXPECT_TRUE(exclusive);
    EXPECT_FALSE(FileLock::acquire(folder.path(), "a", LockKind::Shared));
}

TEST(FileLock, MovedFrom_KeepsTheLock) {
    const TemporaryFolder folder;
    auto first = FileLock::acquire(folder.path(), "a");
    ASSERT_TRUE(first);
    const FileLock second = std::move(*first);
    first.reset();
    EXPECT_FALSE(FileLock::acquire(folder.path(), "a"));
}

// The lock's file is removed and created again all the time, and swept by other writers.
TEST(FileLock, ManyThreads_OneAtATime) {
    const TemporaryFolder folder;
    std::atomic<int> inside{0}, largest{0}, taken{0};
    const auto work = [&] {
        for (int i = 0; i < 50; ++i) {
            const auto lock =
                FileLock::acquire(folder.path(), "a", LockKind::Exclusive, std::chrono::seconds(60));
            if (!lock) continue;
            const int now = ++inside;
            largest = std::max(largest.load(), now);
            ++taken;
            FolderHandle(folder.path(), folder.path()).removeLeftOvers();
            std::this_thread::yield();
            --inside;
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back(work);
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(largest, 1);
    EXPECT_EQ(taken, 400);
    EXPECT_EQ(folder.fileCount(), 0u);
}

} // namespace
} // namespace plumbline
