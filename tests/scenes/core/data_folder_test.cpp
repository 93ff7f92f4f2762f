#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "tests/temporary_folder.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

/// A valid data folder.
fs::path makeData(const fs::path& folder) {
    for (const char* subfolder : {"scenes", "realtime", "validate"})
        fs::create_directories(folder / subfolder);
    return folder;
}

TEST(DataFolder, SearchOrder_IsEnvironmentInstallationSource) {
    const TemporaryFolder folder;
    const fs::path named = makeData(folder / "named"), source = makeData(folder / "source"),
                   bin = folder / "prefix/bin";
    EXPECT_EQ(chooseDataFolder(nullptr, bin, source), source);
    EXPECT_EQ(chooseDataFolder(nullptr, {}, source), source); // /proc can't be read
    const fs::path installed = makeData(folder / "prefix/share/plumbline");
    EXPECT_EQ(chooseDataFolder(nullptr, bin, source), installed);
    EXPECT_EQ(chooseDataFolder("", bin, source), installed);
    EXPECT_EQ(chooseDataFolder(named.c_str(), bin, source), named);
}

std::string machineErrorOf(const char* fromEnvironment, const fs::path& program, const fs::path& source) {
    try {
        return "chose " + chooseDataFolder(fromEnvironment, program, source).string();
    } catch (const MachineError& error) {
        return error.what();
    }
}

TEST(DataFolder, IncompleteFolder_IsAnErrorNotSkipped) {
    const TemporaryFolder folder;
    const fs::path source = makeData(folder / "source"), bin = folder / "prefix/bin",
                   installed = makeData(folder / "prefix/share/plumbline");
    fs::remove(installed / "realtime");
    EXPECT_THAT(machineErrorOf(nullptr, bin, source),
                testing::StartsWith(installed.string() + ": has no folder 'realtime'"));
    EXPECT_THAT(
        machineErrorOf((folder / "nowhere").c_str(), bin, source),
        testing::AllOf(testing::StartsWith((folder / "nowhere").string() + ": has no folder 'scenes'"),
                       testing::HasSubstr("PLUMBLINE_DATA names it")));
    EXPECT_THAT(machineErrorOf(nullptr, {}, folder / "gone"), testing::HasSubstr("set PLUMBLINE_DATA"));
}

} // namespace
} // namespace plumbline
