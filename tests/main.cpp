// main() of every test program.
#include <gtest/gtest.h>

#include <gmock/gmock.h>

/// Exit code if no test failed but one was skipped; CTest reports it as skipped. The output contains the
/// reason.
constexpr int kSkipped = 77;

int main(int argc, char** argv) {
    testing::InitGoogleMock(&argc, argv);
    const int failed = RUN_ALL_TESTS();
    const bool skipped = testing::UnitTest::GetInstance()->skipped_test_count() > 0;
    return failed == 0 && skipped ? kSkipped : failed;
}
