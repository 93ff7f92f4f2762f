// Checks the rule of the layout in the sources: scenes/ contains what reference/ and realtime/ must agree on,
// these two never include each other, and within each of them folders include only those listed before them.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {
namespace {

/// What the files of a folder may include, in addition to files of that folder: folders with their
/// subfolders, or single headers. Only earlier rows may be listed, so that no two folders include each other.
/// A file belongs to the longest name that is a prefix of its path.
struct Folder {
    std::string_view name;
    std::vector<std::string_view> mayInclude;
};

const std::vector<Folder>& folders() {
    static const std::vector<Folder> table{
        {"scenes/core", {}},
        {"scenes/toml", {"scenes/core"}},
        {"scenes/image", {"scenes/core"}},
        {"scenes/mesh", {"scenes/core"}},
        {"scenes/maps", {"scenes/core", "scenes/image"}},
        {"scenes/scene", {"scenes/core", "scenes/maps", "scenes/mesh"}},
        {"scenes/surface", {"scenes/core", "scenes/maps", "scenes/mesh", "scenes/scene"}},
        {"scenes/scene_file",
         {"scenes/core", "scenes/toml", "scenes/maps", "scenes/mesh", "scenes/scene", "scenes/surface"}},
        {"scenes/draft", {"scenes/core", "scenes/toml", "scenes/mesh", "scenes/scene", "scenes/surface"}},
        {"scenes/frame", {"scenes/core", "scenes/image", "scenes/scene"}},
        {"reference/tessellate", {"scenes"}},
        {"reference/export", {"scenes"}},
        {"reference/trace", {"scenes", "reference/tessellate"}},
        {"reference/rates", {"scenes", "reference/tessellate", "reference/trace"}},
        {"reference/certify", {"scenes", "reference/tessellate", "reference/trace", "reference/rates"}},
        {"reference", {"scenes"}},
        {"realtime/bake", {"scenes"}},
        {"realtime/glsl", {"scenes/core"}},
        {"realtime/technique", {"scenes", "realtime/bake", "realtime/glsl"}},
        {"realtime/gl", {"scenes/core", "realtime/glsl"}},
        {"realtime/draw", {"scenes", "realtime/bake", "realtime/glsl", "realtime/technique", "realtime/gl"}},
        {"realtime", {"scenes"}},
        {"validate/metrics",
         {"scenes/core", "scenes/frame/frame.h", "scenes/frame/object_info.h", "scenes/scene/camera.h",
          "scenes/scene/light.h"}},
        {"validate/worker", {"scenes", "realtime"}},
        {"validate", {"scenes", "reference", "realtime"}},
    };
    return table;
}

bool isWithin(std::string_view path, std::string_view folder) {
    return path == folder || (path.starts_with(folder) && path[folder.size()] == '/');
}

const Folder* folderOf(std::string_view path) {
    const Folder* longest = nullptr;
    for (const Folder& folder : folders())
        if (isWithin(path, folder.name) && (!longest || folder.name.size() > longest->name.size()))
            longest = &folder;
    return longest;
}

bool mayInclude(const Folder& folder, std::string_view header) {
    return isWithin(header, folder.name) ||
           std::ranges::any_of(folder.mayInclude,
                               [&](std::string_view name) { return isWithin(header, name); });
}

/// The path in `#include "PATH"`; empty for any other line.
std::string_view includedBy(std::string_view line) {
    constexpr std::string_view kInclude = "#include \"";
    if (!line.starts_with(kInclude)) return {};
    line.remove_prefix(kInclude.size());
    return line.substr(0, line.find('"'));
}

std::vector<std::string> offensesIn(const std::filesystem::path& root, const std::filesystem::path& file) {
    std::vector<std::string> offenses;
    const std::string path = file.lexically_relative(root).generic_string();
    const Folder* folder = folderOf(path);
    std::ifstream stream(file);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        const std::string_view header = includedBy(line);
        if (!header.empty() && !mayInclude(*folder, header))
            offenses.push_back(fmt::format("{}:{}: includes {}; {} may include itself, {}", path, number,
                                           header, folder->name, fmt::join(folder->mayInclude, ", ")));
    }
    return offenses;
}

TEST(IncludeOrder, EveryFile_IncludesOnlyFoldersBelow) {
    const std::filesystem::path root = PLUMBLINE_SOURCE_DIR;
    std::vector<std::string> offenses;
    size_t files = 0;
    for (const char* module : {"scenes", "reference", "realtime", "validate"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / module)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp") continue;
            ++files;
            const std::vector<std::string> found = offensesIn(root, entry.path());
            offenses.insert(offenses.end(), found.begin(), found.end());
        }
    std::ranges::sort(offenses);
    EXPECT_TRUE(offenses.empty()) << fmt::format("{}", fmt::join(offenses, "\n"));
    EXPECT_GT(files, 100u); // the sources were found
}

/// What opens a file for reading. Files of the system (/proc, cgroups) aren't inputs.
TEST(OpenedFiles, Inputs_AreOpenedInOnePlace) {
    constexpr std::array<std::string_view, 4> kWays{"ifstream", "std::fstream", "fopen(",
                                                    "InputFile input(file.c_str"};
    constexpr std::array<std::string_view, 2> kMay{"scenes/core/read_file.cpp",
                                                   "scenes/core/free_memory.cpp"};
    const std::filesystem::path root = PLUMBLINE_SOURCE_DIR;
    for (const char* module : {"scenes", "reference", "realtime", "validate"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / module)) {
            const std::string path = entry.path().lexically_relative(root).generic_string();
            const std::string extension = entry.path().extension().string();
            if ((extension != ".h" && extension != ".cpp") || std::ranges::find(kMay, path) != kMay.end())
                continue;
            std::ifstream stream(entry.path());
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            for (const std::string_view way : kWays)
                EXPECT_EQ(text.find(way), std::string::npos)
                    << path << ": " << way << ": open it with scenes/core/read_file.h";
        }
}

/// Whether the files of a row are in the named folder, or the row contains the named header.
bool covers(std::string_view name, const Folder& row) {
    return isWithin(row.name, name) || folderOf(name) == &row;
}

TEST(IncludeOrder, Table_NamesOnlyEarlierFolders) {
    for (size_t row = 0; row < folders().size(); ++row)
        for (const std::string_view name : folders()[row].mayInclude)
            for (size_t below = row; below < folders().size(); ++below)
                EXPECT_FALSE(covers(name, folders()[below]))
                    << folders()[row].name << " names " << name << ", which isn't above it";
}

} // namespace
} // namespace plumbline
