// A study: scenes x values of their fields x techniques, and what is to be shown of it. A TOML file; every
// key is in README.md beside this.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace plumbline {

/// A field of the scene, or several that go together, and the values it takes, as TOML writes them.
struct StudyAxis {
    std::string name;
    std::vector<std::string> fields; // "object.subject.relief.depth"
    std::vector<std::string> values; // "0.1"
};

struct StudyTechnique {
    std::string label; // in tables and plots
    std::string name;  // SEARCH[@SURFACE][:key=value,…]
};

/// Two techniques, by their labels, whose pictures of each case are held against each other.
struct StudyPair {
    std::string first, second;
};

/// Every scene at every combination of values, drawn by every technique.
struct StudyGrid {
    std::string name;
    std::vector<std::string> scenes; // names of the library, or files as the study names them
    std::vector<std::filesystem::path> sceneFiles;
    std::vector<std::string> sceneChanges; // of all its cases
    std::vector<StudyAxis> axes;
    std::vector<StudyTechnique> techniques;
    std::vector<std::string> settings; // key=value, of all techniques
    std::vector<StudyPair> pairs;
    double timingBudgetMs = 0; // a technique; 0: drawn once
};

/// What a technique is held against where it isn't another one: no label may be this.
inline constexpr const char* kAgainstReference = "reference";

/// Which rows of the results a table or a plot is made of.
struct StudyRows {
    std::string grid;
    std::string against = kAgainstReference;               // or the label of a pair's first technique
    std::map<std::string, std::vector<std::string>> where; // axis, "scene" or "technique": values allowed
    std::string figure;                                    // column of results.csv
    std::string statistic = "median"; // of the rows that fall together: median, mean, min, max, count
};

struct StudyTable {
    std::string title;
    std::string rows, columns; // an axis, "scene" or "technique"
    StudyRows data;
};

struct StudyPlot {
    std::string title, name;   // name: of its file
    std::string x;             // an axis
    std::string lines, panels; // an axis, "scene" or "technique"; panels may be empty
    bool logX = false, logY = false;
    StudyRows data;
};

struct Study {
    std::string name; // file stem
    std::string title, purpose;
    std::string memory;   // of one reference, as --memory has it
    std::string errorPx;  // as --error-px has it; empty: the reference's own default
    int timeLimitSeconds; // a technique
    std::vector<StudyGrid> grids;
    std::vector<StudyTable> tables;
    std::vector<StudyPlot> plots;
};

/// Throws InputError: "file:line: field: what; expected …".
Study readStudy(const std::filesystem::path& file);

/// The values rows can have by "scene", "technique" or an axis, in the study's order; none for a name there
/// is none of.
std::vector<std::string> groupValues(const StudyGrid& grid, const std::string& grouping);

/// The grid of that name, which must be there.
const StudyGrid& gridNamed(const Study& study, const std::string& name);

/// A path as it is, or a name in validate/studies/. Throws InputError that lists the names.
std::filesystem::path findStudy(const std::string& nameOrPath);

} // namespace plumbline
