#include "validate/cli/report_arguments.h"

#include "scenes/core/printable.h"
#include "validate/report/page_bundle.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace plumbline {

void ReportArguments::addTo(CLI::App& command) {
    command.add_flag("--single-file", singleFile, "Write the report as a single self-contained file");
    command.add_flag("--plain-report", plain,
                     "Write the report without scripts and plots, every image as PNG");
}

ReportOptions ReportArguments::options() const {
    return {.interactive = !plain && !report::pageScript().empty(), .singleFile = singleFile};
}

std::string reportLine(const std::filesystem::path& page) {
    const std::string_view plain = report::plainReportReason();
    return fmt::format("report: {}\n{}", printable(page.string()),
                       plain.empty() ? "" : fmt::format("(a plain one: {})\n", plain));
}

} // namespace plumbline
