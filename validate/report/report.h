// The folder report/: index.html and the pictures it shows, as PNG. Offline, no scripts.
#pragma once

#include "../../scenes/frame.h"
#include "report_page.h"

#include <filesystem>
#include <string>

namespace plumbline {

struct Picture;

/// Paints while the frames are there and writes the page from what it painted, so that a run needs to hold
/// only the reference and one test frame at a time, and a run that is stopped leaves a page of what was
/// finished.
class Report {
  public:
    /// `folder`: the page becomes folder/index.html. Must exist.
    explicit Report(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void addReference(const Frame& reference);
    /// `technique.comparison` must be of these two frames.
    void addTechnique(const TechniqueOutcome& technique, const Frame& reference, const Frame& test);
    /// `gap` must be of these two frames.
    void addBaseGap(const Comparison& gap, const Frame& reference, const Frame& proxyReference);
    /// Techniques without pictures (failed ones) are shown with their error.
    void write(const Results& results) const;

  private:
    std::string save(const std::string& stem, const std::string& what, const Picture& picture) const;
    std::vector<ReportPicture> saveDifferences(const std::string& stem, const Comparison& comparison,
                                               const Frame& reference, const Frame& test) const;
    void saveCurvature(const std::string& stem, const Frame& test, std::vector<ReportPicture>& entries) const;

    std::filesystem::path folder_;
    ReportPictures pictures_;
};

/// Full colour of the signed depth error's map, world units: a quarter of the largest relief depth, so that
/// pictures of different techniques and runs compare; without a relief depth, the comparison's own p95 (1 if
/// that is 0).
struct DepthRange {
    double worldUnits = 1;
    std::string note; // how it came about
};
DepthRange depthRange(const Comparison& comparison);

} // namespace plumbline
