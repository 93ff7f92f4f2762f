#include "validate/study/study_plot.h"

#include "scenes/core/error.h"
#include "scenes/core/folder_handle.h"
#include "scenes/core/numbers.h"
#include "scenes/core/replace_file.h"
#include "scenes/core/write_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace plumbline {
namespace {

// Distinguishable with red-green color blindness, and also by point shapes: Okabe and Ito 2008, without the
// yellow, which is too pale on white.
const std::vector<std::string> kColors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                       "#56b4e9", "#e69f00", "#000000"};

constexpr int kPanelWidth = 340, kPanelHeight = 260, kPanelsInRow = 3, kHead = 46, kKeyRow = 18; // pixels

const std::string& colorOf(size_t line) {
    return kColors[line % kColors.size()];
}

/// Point type of gnuplot's svg terminal: hollow squares, circles, triangles …, then filled ones.
size_t pointOf(size_t line) {
    return 4 + 2 * (line % 5) + line / 5 % 2;
}

/// In single quotes, in which gnuplot interprets nothing. In double quotes it would execute text in
/// backticks.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? "''" : std::string(1, c);
    return result + "'";
}

/// Values of an axis as numbers; if one isn't a number, their indices 1, 2, 3.
struct Positions {
    std::vector<std::string> texts;
    std::vector<double> numbers;
    bool named = false;

    explicit Positions(std::vector<std::string> values) : texts(std::move(values)) {
        for (const std::string& text : texts) {
            const auto number = parseNumber<double>(text);
            numbers.push_back(number.value_or(0));
            named |= !number;
        }
        if (!named) return;
        for (size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = static_cast<double>(i + 1);
    }
    std::string tics() const {
        std::string list;
        for (size_t i = 0; i < texts.size(); ++i)
            list += fmt::format("{}{} {}", i > 0 ? ", " : "", quoted(texts[i]), numbers[i]);
        return fmt::format("set xtics ({})\n", list);
    }
    /// The range of all values, with a margin.
    std::string range(bool log) const {
        const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
        if (log && *low > 0) {
            const double room = std::pow(*high / *low, 0.05) + (*high > *low ? 0 : 1);
            return fmt::format("set xrange [{}:{}]\n", *low / room, *high * room);
        }
        const double room = *high > *low ? 0.05 * (*high - *low) : 1;
        return fmt::format("set xrange [{}:{}]\n", *low - room, *high + room);
    }
};

/// The values of a grouping that occur in rows, in the study's order.
std::vector<std::string> present(const StudyGrid& grid, const std::string& grouping,
                                 const std::vector<StudyRow>& rows, const StudyRows& choice) {
    std::vector<std::string> values = groupValues(grid, grouping);
    std::erase_if(values, [&](const std::string& value) {
        return std::none_of(rows.begin(), rows.end(), [&](const StudyRow& row) {
            return isChosen(row, choice) && row.figures.contains(choice.figure) &&
                   groupOf(row, grouping) == value;
        });
    });
    return values;
}

/// Positions of the line names above the panels: pixels from the left, in rows with as many as fit.
struct Key {
    std::vector<double> x;
    std::vector<int> row;
    int rows = 1;

    Key(const std::vector<std::string>& names, int width) {
        constexpr double kLetter = 7, kGap = 40, kMargin = 20; // pixels; approximate width of the font
        double at = kMargin;
        for (const std::string& name : names) {
            const double wide = kLetter * static_cast<double>(name.size()) + kGap;
            if (at + wide > width && at > kMargin) at = kMargin, ++rows;
            x.push_back(at);
            row.push_back(rows - 1);
            at += wide;
        }
    }
};

/// The script of one panel: data blocks first, then the plot command.
std::string panelScript(const StudyPlot& plot, const StudyRows& choice, const std::vector<StudyRow>& rows,
                        const Positions& x, const std::vector<std::string>& lines, size_t panel) {
    const StudyCells cells = cellsOf(rows, choice, plot.lines, plot.x);
    std::string data, command;
    for (size_t line = 0; line < lines.size(); ++line) {
        std::string points;
        for (size_t i = 0; i < x.texts.size(); ++i) {
            const auto found = cells.values.find({lines[line], x.texts[i]});
            const bool drawable = found != cells.values.end() && (!plot.logY || found->second > 0);
            if (drawable) points += fmt::format("{} {}\n", x.numbers[i], found->second);
        }
        if (points.empty()) continue;
        const std::string block = fmt::format("$p{}l{}", panel, line);
        data += fmt::format("{} << EOD\n{}EOD\n", block, points);
        command += fmt::format("{}{} using 1:2 with linespoints lw 1.5 pt {} ps 0.6 lc rgb '{}' notitle",
                               command.empty() ? "plot " : ", ", block, pointOf(line), colorOf(line));
    }
    if (command.empty()) return "set multiplot next\n";
    return data + command + "\n";
}

/// The script as a file without a name, as stdin of gnuplot: it may be too long for a pipe's buffer.
Descriptor scriptFile(const std::string& script) {
    Descriptor file(::memfd_create("gnuplot", MFD_CLOEXEC));
    if (file.get() < 0) failWrite("the plot's script", errno);
    OutputStream stream(file.get(), "the plot's script");
    stream.write(script);
    stream.seek(0);
    return file;
}

/// Runs gnuplot on a script and writes its output to an empty file.
bool runGnuplot(const std::string& script, int output) {
    const Descriptor input = scriptFile(script);
    std::string program = "gnuplot";
    char* const arguments[] = {program.data(), nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input.get(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    pid_t process = -1;
    int status = 0;
    const bool done = ::posix_spawnp(&process, "gnuplot", &actions, nullptr, arguments, environ) == 0 &&
                      ::waitpid(process, &status, 0) == process && status == 0;
    posix_spawn_file_actions_destroy(&actions);
    return done && ::lseek(output, 0, SEEK_END) > 0;
}

} // namespace

std::string gnuplotScript(const Study& study, const StudyPlot& plot, const std::vector<StudyRow>& rows) {
    checkFigure(rows, plot.data);
    const StudyGrid& grid = gridNamed(study, plot.data.grid);
    const Positions x(groupValues(grid, plot.x));
    const std::vector<std::string> lines = present(grid, plot.lines, rows, plot.data);
    const std::vector<std::string> panels =
        plot.panels.empty() ? std::vector<std::string>{""} : present(grid, plot.panels, rows, plot.data);
    if (lines.empty() || panels.empty()) return {};
    const int columns = std::min<int>(kPanelsInRow, static_cast<int>(panels.size()));
    const int panelRows = (static_cast<int>(panels.size()) + columns - 1) / columns;
    const int width = std::max(columns, 2) * kPanelWidth;
    const Key key(lines, width);
    const int head = kHead + key.rows * kKeyRow, height = panelRows * kPanelHeight + head;
    // Above the panels: the title, the figure and statistic, and the common key.
    std::string script = fmt::format(
        "set terminal svg size {},{} font 'sans-serif,12' noenhanced background '#ffffff'\n"
        "set label 1 {} at screen 0.5,{:.4f} center font 'sans-serif,14'\n"
        "set label 2 {} at screen 0.5,{:.4f} center textcolor rgb '#555555'\n",
        width, height, quoted(plot.title), 1 - 14.0 / height,
        quoted(plot.data.statistic + " of " + plot.data.figure + " over " + plot.x), 1 - 32.0 / height);
    for (size_t i = 0; i < lines.size(); ++i)
        script +=
            fmt::format("set label {} {} at screen {:.4f},{:.4f} left textcolor rgb '{}' point pt {} ps 0.8 "
                        "lc rgb '{}' offset 1,0\n",
                        i + 3, quoted(lines[i]), key.x[i] / width, 1 - (54.0 + kKeyRow * key.row[i]) / height,
                        colorOf(i), pointOf(i), colorOf(i));
    script += fmt::format("set multiplot layout {},{} margins 0.07,0.98,{:.4f},{:.4f} spacing 0.07,{:.4f}\n",
                          panelRows, columns, 32.0 / height, 1 - (head + 24.0) / height, 62.0 / height);
    script += "set grid lc rgb \"#dddddd\"\nset border lc rgb \"#444444\"\nset tics font "
              "\"sans-serif,10\"\nset format y \"%g\"\n";
    if (plot.logX && !x.named) script += "set logscale x\n";
    if (plot.logY) script += "set logscale y\n";
    script += x.tics() + x.range(plot.logX && !x.named);
    for (size_t panel = 0; panel < panels.size(); ++panel) {
        StudyRows choice = plot.data;
        if (!plot.panels.empty()) choice.where[plot.panels] = {panels[panel]};
        const bool isValue = plot.panels != "scene" && plot.panels != "technique" && !plot.panels.empty();
        script += fmt::format("set title {} offset 0,-0.7\n",
                              quoted(isValue ? plot.panels + " " + panels[panel] : panels[panel]));
        script += panelScript(plot, choice, rows, x, lines, panel);
        if (panel == 0) script += fmt::format("unset for [i=1:{}] label i\n", lines.size() + 2);
    }
    return script + "unset multiplot\n";
}

void requireGnuplot() {
    if (std::system("gnuplot --version >/dev/null 2>&1") != 0)
        throw MachineError("study report", "gnuplot is missing",
                           "gnuplot for the plots (apt install gnuplot-nox)");
}

bool drawPlot(const Study& study, const StudyPlot& plot, const std::vector<StudyRow>& rows,
              const std::filesystem::path& file) {
    const std::string script = gnuplotScript(study, plot, rows);
    if (script.empty()) return false;
    replaceFile(file, [&](OutputStream& stream) {
        if (!runGnuplot(script, stream.descriptor()))
            throw MachineError("gnuplot", fmt::format("plot '{}' failed", plot.name), "gnuplot 5 or later");
    });
    return true;
}

} // namespace plumbline
