// Compares figures between records of a history and finds the regressions.
#pragma once

#include "validate/results/history.h"

namespace plumbline {

/// How much worse than before a figure may become.
class Tolerances {
  public:
    /// "silhouette.iou=0.001", "shadow.sun.iou=0.01", "depth.rmse=2%" of the previous value, "all=1%". A
    /// shadow key without a light applies to every light. The most specific one is used: with a light,
    /// without one, "all". Throws InputError for a text that isn't of this form, an amount below 0, a key
    /// that isn't in `plumbline list metrics` or has no goal, or a key given twice.
    static Tolerances parse(const std::vector<std::string>& texts);

    /// The tolerance for a figure whose previous value is `before`, in its unit; nullopt if none was given.
    /// "all" doesn't apply to cost.
    std::optional<double> of(const std::string& figure, double before) const;

  private:
    struct Amount {
        double value = 0;
        bool relative = false; // to the previous value
    };
    std::map<std::string, Amount> amounts_;
};

enum class Verdict { Neutral, Better, Tolerated, Regression };

struct FigureMove {
    std::string technique, figure;
    std::optional<double> before, after; // nullopt: absent
    Verdict verdict = Verdict::Neutral;
    double tolerated = 0; // how much worse it was allowed to become
};

/// The latest record of a scene compared with the one before it.
struct SceneMoves {
    std::string scene;
    std::string before, after;     // labels; `before` is empty if there is no comparable record (see notes)
    std::vector<FigureMove> moves; // figures that changed
    std::vector<std::pair<std::string, size_t>> unmoved; // technique, number of unchanged figures
    std::vector<std::string> notes;                      // a sentence each
    std::vector<std::string> failures; // of techniques that worked before; these are regressions
    bool hasRegression() const;
};

/// Compares the latest record of each of `scenes` (of all scenes, if empty) with the one before it. Scenes
/// are in the order of their first records.
///
/// Records are comparable if they have the same scene, scene hash and base. A technique is compared with the
/// latest such record in which it worked. A figure is worse if it is farther from its best value (Goal in
/// validate/metrics/metric.h). Without a tolerance,
/// - a figure with an interval (…_low to …_high) may fall to the lower end of its previous interval, because
///   that difference is within the error of the reference;
/// - counts of pixels are never regressions, because the ratio computed from them is evaluated;
/// - cost is never a regression, because times are noisy and the user decides what lookups are worth;
/// - any other figure must not become worse, because equal inputs give equal figures (on llvmpipe to the last
///   bit).
/// A figure with a best value that is now absent is a regression.
std::vector<SceneMoves> latestMoves(const std::vector<HistoryRecord>& records,
                                    const std::vector<std::string>& scenes, const Tolerances& tolerances);

} // namespace plumbline
