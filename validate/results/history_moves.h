// How figures moved from one record of a history to the next, and which of the moves are regressions.
#pragma once

#include "validate/results/history.h"

namespace plumbline {

/// How much worse than before a figure may be.
class Tolerances {
  public:
    /// "silhouette.iou=0.001", "shadow.sun.iou=0.01", "depth.rmse=2%" of the value before, "all=1%"; a
    /// shadow's key without a light holds for every light, one with it before that, either before "all".
    /// Throws InputError for a text that isn't of the form, an amount below 0, a key that `plumbline list
    /// metrics` hasn't or that is neither better nor worse, one given twice.
    static Tolerances parse(const std::vector<std::string>& texts);

    /// What was asked for for a figure that was `before`, in its unit; none: nothing. "all" isn't about cost.
    std::optional<double> of(const std::string& figure, double before) const;

  private:
    struct Amount {
        double value = 0;
        bool relative = false; // of the value before
    };
    std::map<std::string, Amount> amounts_;
};

enum class Verdict { Neutral, Better, Tolerated, Regression };

struct FigureMove {
    std::string technique, figure;
    std::optional<double> before, after; // none: it had no value
    Verdict verdict = Verdict::Neutral;
    double tolerated = 0; // how much worse it might have become
};

/// The latest record of a scene against the one before it.
struct SceneMoves {
    std::string scene;
    std::string before, after;     // labels; no `before`: nothing to compare with, a note says why
    std::vector<FigureMove> moves; // what moved
    std::vector<std::pair<std::string, size_t>> unmoved; // technique, figures that are as before
    std::vector<std::string> notes;                      // a sentence each
    std::vector<std::string> failures;                   // of techniques that worked before: regressions
    bool hasRegression() const;
};

/// The latest record of each of `scenes` (all there are, if none is named) held against the one before it; by
/// their first record.
///
/// Records compare if they have the scene's hash and base in common. A technique is held against the latest
/// such record in which it worked. A figure is worse if it is farther from its best value (Goal in
/// validate/metrics/metric.h). Unless a tolerance says otherwise,
/// - one with an interval (…_low to …_high) may be anywhere in the interval it had: the reference can't tell
/// there;
/// - counts of pixels aren't judged: the ratio made of them is;
/// - cost is never a regression: times are noise, and what look-ups are worth is the user's to say;
/// - any other may not become worse at all: equal inputs give equal figures (on llvmpipe, to the last bit).
/// A figure with a best value that has no value any more is a regression.
std::vector<SceneMoves> latestMoves(const std::vector<HistoryRecord>& records,
                                    const std::vector<std::string>& scenes, const Tolerances& tolerances);

} // namespace plumbline
