// The installed program, after its prefix was moved.
#include "scenes/core/data_folder.h"
#include "tests/end_to_end/installed_program.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using namespace test;
using testing::HasSubstr;
using testing::Not;

using Install = EndToEnd;

TEST_F(Install, MovedPrefix_FindsDataAndModule) {
    const fs::path moved = installAndMove(folder_);
    fs::create_symlink(moved / "bin/plumbline", folder_ / "link");
    for (const fs::path& program : {moved / "bin/plumbline", folder_ / "link"}) {
        const std::string doctor = shell(program.string() + " doctor").text;
        EXPECT_THAT(doctor, HasSubstr("ok   data             " + (moved / "share/plumbline").string() + ","));
        EXPECT_THAT(doctor, HasSubstr("ok   pictures         " +
                                      (moved / "lib/plumbline/plumbline_images.so").string() + "\n"));
        EXPECT_THAT(doctor, HasSubstr("ok   techniques       "));
    }
}

TEST_F(Install, Installed_ReadsNoSourceFiles) {
    const fs::path moved = installAndMove(folder_);
    const std::string program = (moved / "bin/plumbline").string();
    writeFile(moved / "share/plumbline/scenes/library/only_here.toml", kSmallScene);
    EXPECT_THAT(shell(program + " list scenes").text, HasSubstr("only_here "));

    fs::remove_all(moved / "share/plumbline/validate");
    const ShellOutcome damaged = shell(program + " list scenes");
    EXPECT_EQ(damaged.exitCode, 3);
    EXPECT_THAT(damaged.text,
                testing::StartsWith((moved / "share/plumbline").string() + ": has no folder 'validate'"));
}

TEST_F(Install, Installed_DrawsAndWritesReports) {
    const std::string program = (installAndMove(folder_) / "bin/plumbline").string();
    const std::string scene = writeSmallScene().string(), frame = (folder_ / "frame.exr").string();
    const ShellOutcome reference = shell(program + " reference " + scene + " -o " + frame);
    ASSERT_EQ(reference.exitCode, 0) << reference.text;
    const ShellOutcome compare =
        shell(program + " compare " + frame + " " + frame + " -o " + (folder_ / "out").string());
    EXPECT_EQ(compare.exitCode, 0) << compare.text;
    EXPECT_THAT(filesBelow(folder_ / "out"), testing::Contains("report/index.html"));
}

/// Relative paths of the files below `folder`/`subfolder` that end in one of `endings`.
std::vector<std::string> filesWith(const fs::path& folder, const char* subfolder,
                                   const std::vector<std::string>& endings) {
    std::vector<std::string> found;
    for (const std::string& file : filesBelow(folder / subfolder))
        for (const std::string& ending : endings)
            if (file.ends_with(ending)) found.push_back(std::string(subfolder) + "/" + file);
    return found;
}

TEST_F(Install, Installed_HasRuntimeFilesOnly) {
    const fs::path moved = installAndMove(folder_), source = dataFolder();
    std::vector<std::string> files = filesWith(source, "scenes/library", {".toml"});
    for (const char* subfolder : {"realtime/shaders", "realtime/surfaces", "realtime/techniques",
                                  "validate/report", "validate/studies"})
        for (std::string& file :
             filesWith(source, subfolder, {".toml", ".glsl", ".vert", ".geom", ".mustache"}))
            files.push_back(std::move(file));
    EXPECT_GT(files.size(), 60u);
    for (const std::string& file : files)
        EXPECT_TRUE(fs::exists(moved / "share/plumbline" / file)) << file;
    EXPECT_EQ(filesBelow(moved / "bin"), std::vector<std::string>{"plumbline"});
    EXPECT_EQ(filesBelow(moved / "lib"), std::vector<std::string>{"plumbline/plumbline_images.so"});
}

TEST_F(Install, NoOpenGlLibrary_StillStarts) {
    const ShellOutcome libraries = shell("ldd " PLUMBLINE_PROGRAM);
    ASSERT_EQ(libraries.exitCode, 0) << libraries.text;
    for (const char* library : {"libEGL", "libGL", "libOpenGL", "libOSMesa"})
        EXPECT_THAT(libraries.text, Not(HasSubstr(library)));
}

} // namespace
} // namespace plumbline
