// A study: scenes x values of their fields x techniques, and the tables and plots of the results. It is a
// TOML file; README.md in this folder describes its keys.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace plumbline {

/// A field of the scene, or several with the same value, and its values in TOML syntax.
struct StudyAxis {
    std::string name;
    std::vector<std::string> fields; // "object.subject.relief.depth"
    std::vector<std::string> values; // "0.1"
};

struct StudyTechnique {
    std::string label; // in tables and plots
    std::string name;  // SEARCH[@SURFACE][:key=value,…]
};

/// Two techniques, by their labels, whose frames of each case are compared with each other.
struct StudyPair {
    std::string first, second;
};

/// Every scene with every combination of values, drawn by every technique.
struct StudyGrid {
    std::string name;
    std::vector<std::string> scenes; // names of the library, or files, as in the study
    std::vector<std::filesystem::path> sceneFiles;
    std::vector<std::string> sceneChanges; // in all cases
    std::vector<StudyAxis> axes;
    std::vector<StudyTechnique> techniques;
    std::vector<std::string> settings; // key=value, for all techniques
    std::vector<StudyPair> pairs;
    double timingBudgetMs = 0; // per technique; 0: drawn once
};

/// Value of `against` for a comparison with the reference. No label may be equal to it.
inline constexpr const char* kAgainstReference = "reference";

/// Selects the rows of the results for a table or a plot.
struct StudyRows {
    std::string grid;
    std::string against = kAgainstReference;               // or the label of a pair's first technique
    std::map<std::string, std::vector<std::string>> where; // axis, "scene" or "technique" to selected values
    std::string figure;                                    // column of results.csv
    std::string statistic = "median"; // of the rows in one group: median, mean, min, max, count
};

struct StudyTable {
    std::string title;
    std::string rows, columns; // an axis, "scene" or "technique"
    StudyRows data;
};

struct StudyPlot {
    std::string title, name;   // name: of the file
    std::string x;             // an axis
    std::string lines, panels; // an axis, "scene" or "technique"; panels may be empty
    bool logX = false, logY = false;
    StudyRows data;
};

struct Study {
    std::string name; // file stem
    std::string title, purpose;
    std::string memory;   // for one reference, as in --memory
    std::string errorPx;  // as in --error-px; empty: the default of the reference
    int timeLimitSeconds; // per technique
    std::vector<StudyGrid> grids;
    std::vector<StudyTable> tables;
    std::vector<StudyPlot> plots;
};

/// Throws InputError: "file:line: field: what; expected …".
Study readStudy(const std::filesystem::path& file);

/// The values of "scene", "technique" or an axis, in the study's order; empty for an unknown name.
std::vector<std::string> groupValues(const StudyGrid& grid, const std::string& grouping);

/// The grid of that name, which must exist.
const StudyGrid& gridNamed(const Study& study, const std::string& name);

/// The path itself, or the file of a name in validate/studies/. Throws InputError that lists the names.
std::filesystem::path findStudy(const std::string& nameOrPath);

} // namespace plumbline
