// The folder report/: index.html and the files it shows. It can be opened from disk, offline.
//
// With the interactive page (page_bundle.h): index.html, report.js, data/*.js with the planes of each frame,
// and images of curvatures. Without it: index.html without scripts, and every image as PNG. As a single file:
// index.html with everything embedded.
#pragma once

#include "scenes/frame/frame.h"
#include "validate/report/failing_pixels.h"
#include "validate/report/frame_data.h"
#include "validate/report/report_data.h"
#include "validate/report/report_page.h"
#include "validate/results/unique_file_names.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace plumbline {

struct Picture;

struct ReportOptions {
    bool interactive = true; // requires pageScript()
    bool singleFile = false;
};

/// Writes the images and planes of each frame when it is added, so that a run has only the reference and one
/// test frame in memory, and an interrupted run leaves a page with what was finished.
class Report {
  public:
    /// The page is written to folder/index.html. `folder` must exist.
    Report(std::filesystem::path folder, ReportOptions options);

    void addReference(const Frame& reference);
    /// `technique.comparison` must be of these two frames.
    void addTechnique(const TechniqueOutcome& technique, const Frame& reference, const Frame& test);
    /// `gap` must be of these two frames.
    void addBaseGap(const Comparison& gap, const Frame& reference, const Frame& proxyReference);
    /// Techniques that failed are shown with their error. A single file is written only at the last call.
    void write(const Results& results, bool last);

  private:
    std::string save(const std::string& stem, const std::string& what, const Picture& picture);
    std::vector<ReportPicture> saveDifferences(const std::string& stem, const Comparison& comparison,
                                               const FramePair& pair);
    void saveCurvature(const std::string& stem, const Frame& test, std::vector<ReportPicture>& entries);
    void saveFrame(report::FrameEntry entry, const report::FrameData& frame);
    void saveReference(const FramePair& pair, std::span<const float> depth);
    void saveTest(const std::string& stem, report::FrameEntry entry, const Comparison& comparison,
                  const FramePair& pair);

    std::filesystem::path folder_;
    ReportOptions options_;
    UniqueFileNames pictureNames_; // without their suffix
    ReportPictures pictures_;
    report::ReportData data_;
    report::FailingPixels failing_;
    std::map<std::string, std::string> embedded_; // planes of frames by file, if the report is a single file
};

} // namespace plumbline
