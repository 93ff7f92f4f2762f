// main() of every test program.
#include <gtest/gtest.h>

#include <gmock/gmock.h>

/// Nothing failed, but something was skipped: its output says what and why. CTest reports it as skipped.
constexpr int kSkipped = 77;

int main(int argc, char** argv) {
    testing::InitGoogleMock(&argc, argv);
    const int failed = RUN_ALL_TESTS();
    const bool skipped = testing::UnitTest::GetInstance()->skipped_test_count() > 0;
    return failed == 0 && skipped ? kSkipped : failed;
}
