// Replays the corpus of the fuzzer: inputs that once failed, small valid ones, and files of the tree.
#include "tests/fuzz/fuzz_targets.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace plumbline {
namespace {

std::vector<uint8_t> bytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class FuzzCorpus : public testing::TestWithParam<FuzzTarget> {};

TEST_P(FuzzCorpus, every_input_is_read_or_refused) {
    const FuzzTarget& target = GetParam();
    const std::filesystem::path folder =
        std::filesystem::path(PLUMBLINE_SOURCE_DIR) / "tests/fuzz/corpus" / target.name;
    int read = 0, refused = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::vector<uint8_t> bytes = bytesOf(entry.path());
        const bool mustBeRead = entry.path().filename().string().starts_with("valid");
        try {
            target.read(bytes);
            ++read;
        } catch (const std::runtime_error& error) { // any other exception fails the test
            ++refused;
            EXPECT_FALSE(mustBeRead) << entry.path() << ": " << error.what();
        }
        // What a killed writer or a full disk leaves.
        for (const size_t length : {bytes.size() / 2, bytes.size() - bytes.size() / 8}) {
            try {
                target.read(FuzzInput(bytes).first(length));
            } catch (const std::runtime_error&) {
            }
        }
    }
    EXPECT_GT(read, 0) << "no input is valid";
    EXPECT_GT(refused, 0) << "no input is refused";
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpus, testing::ValuesIn(fuzzTargets().begin(), fuzzTargets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

} // namespace
} // namespace plumbline
