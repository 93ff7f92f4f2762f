// Follows the five steps of the README's "Add a technique in five steps" in an empty folder.
#include "scenes/core/data_folder.h"
#include "tests/end_to_end/program.h"

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <regex>
#include <sstream>

namespace plumbline::test {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;

/// The numbered steps of the README's section, in order.
std::vector<std::string> readmeSteps() {
    const std::string readme = readFile(dataFolder() / "README.md");
    const size_t begin = readme.find("## Add a technique in five steps"),
                 end = readme.find("\n## ", begin + 1);
    std::istringstream section(readme.substr(begin, end - begin));
    std::vector<std::string> steps;
    for (std::string line; std::getline(section, line);)
        if (line.size() > 2 && line[0] == static_cast<char>('1' + steps.size()) && line[1] == '.')
            steps.push_back(line);
    return steps;
}

/// Every text between backticks.
std::vector<std::string> quoted(const std::string& step) {
    std::vector<std::string> texts;
    const std::regex pattern("`([^`]+)`");
    for (std::sregex_iterator it(step.begin(), step.end(), pattern); it != std::sregex_iterator(); ++it)
        texts.push_back((*it)[1]);
    return texts;
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

class Tutorial : public EndToEnd {};

TEST_F(Tutorial, ReadmesFiveSteps_GiveRunningTechnique) {
    const std::vector<std::string> steps = readmeSteps();
    ASSERT_EQ(steps.size(), 5u);

    // 1. Copy the template.
    const std::vector<std::string> copy = quoted(steps[0]);
    ASSERT_GE(copy.size(), 2u) << steps[0];
    const std::filesystem::path mine = folder_ / copy[1];
    std::filesystem::copy(dataFolder() / copy[0], mine.parent_path(),
                          std::filesystem::copy_options::recursive);

    // 2. Rename the shader and write its function.
    const std::vector<std::string> rename = quoted(steps[1]);
    ASSERT_EQ(rename.size(), 3u) << steps[1];
    std::filesystem::rename(mine.parent_path() / rename[0], mine.parent_path() / rename[1]);
    EXPECT_THAT(readFile(mine.parent_path() / rename[1]), HasSubstr(rename[2]));

    // 3. Set the title in the manifest.
    const std::vector<std::string> name = quoted(steps[2]);
    ASSERT_THAT(name, Contains("technique.toml"));
    const std::filesystem::path manifest = mine.parent_path() / "technique.toml";
    std::string text = readFile(manifest);
    const std::regex title("title = \"[^\"]*\"");
    ASSERT_TRUE(std::regex_search(text, title));
    writeFile(manifest, std::regex_replace(text, title, "title = \"My technique\""));

    // 4. Run it without building.
    std::vector<std::string> command;
    for (const std::string& candidate : quoted(steps[3]))
        if (candidate.starts_with("./plumbline validate")) command = words(candidate);
    ASSERT_GT(command.size(), 2u) << steps[3];
    command.erase(command.begin());
    const Outcome validated = run(command);
    ASSERT_EQ(validated.exitCode, 0) << validated.err;
    EXPECT_THAT(validated.out, HasSubstr("my_technique"));
    EXPECT_THAT(validated.out, HasSubstr("linear_binary"));

    // 5. Read the report; change a parameter with the given option.
    const std::filesystem::path report = folder_ / "plumbline-out" / command[1] / "report" / "index.html";
    EXPECT_THAT(readFile(report), HasSubstr("my_technique"));
    std::string change;
    for (const std::string& candidate : quoted(steps[4]))
        if (candidate.starts_with("--technique ")) change = words(candidate)[1];
    ASSERT_NE(change, "") << steps[4];
    const Outcome changed = run({"validate", command[1], "--technique", change, "-o", "changed"});
    ASSERT_EQ(changed.exitCode, 0) << changed.err;
    const json results = json::parse(readFile(folder_ / "changed" / "results.json"));
    EXPECT_EQ(results["techniques"][0]["name"], change);
}

} // namespace
} // namespace plumbline::test
