// The contents of the tarball: the installed program with its libraries, which must not need those of this
// machine.
#include "tests/end_to_end/installed_program.h"

#include <gmock/gmock.h>
#include <regex>
#include <sstream>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using namespace test;

using Bundle = EndToEnd;

TEST_F(Bundle, BundledProgram_NeedsOnlyCAndCxxRuntime) {
    if (shell("patchelf --version").exitCode != 0) GTEST_SKIP() << "patchelf is missing";
    const fs::path moved = installAndMove(folder_, {"bundle"}), libraries = moved / "lib/plumbline";
    std::vector<fs::path> loaded{moved / "bin/plumbline", libraries / "plumbline_images.so"};
    if (fs::exists(libraries / "libOSMesa.so.8")) loaded.push_back(libraries / "libOSMesa.so.8");

    // Lines of ldd: "name => path (address)", "name => not found", "path (address)".
    const std::regex runtime(
        "\\S*(linux-vdso|ld-linux-x86-64|libc|libm|libmvec|libdl|librt|libpthread|libresolv|libutil|"
        "libstdc\\+\\+|libgcc_s)\\.so\\.\\d+ .*");
    const std::regex found("\\S+ => (\\S+) \\(.*");
    size_t bundled = 0;
    for (const fs::path& file : loaded) {
        const ShellOutcome outcome = shell("ldd " + file.string());
        EXPECT_EQ(outcome.exitCode, 0) << outcome.text;
        std::istringstream lines(outcome.text);
        for (std::string line; std::getline(lines, line);) {
            line.erase(0, line.find_first_not_of(" \t"));
            if (std::regex_match(line, runtime)) continue;
            std::smatch parts;
            const bool isFound = std::regex_match(line, parts, found);
            EXPECT_TRUE(isFound && fs::path(parts[1].str()).lexically_normal().parent_path() == libraries)
                << file << " needs " << line;
            ++bundled;
        }
    }
    EXPECT_GT(bundled, 20u); // Embree, TBB, OpenSubdiv, OpenEXR, OpenImageIO and their dependencies
    const ShellOutcome doctor = shell((moved / "bin/plumbline").string() + " doctor");
    EXPECT_THAT(doctor.text, testing::HasSubstr("ok   pictures         " + libraries.string()));
    EXPECT_THAT(filesBelow(moved / "share/doc/plumbline/bundled"), testing::Contains("packages.txt"));
}

} // namespace
} // namespace plumbline
