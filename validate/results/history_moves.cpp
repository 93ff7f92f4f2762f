#include "validate/results/history_moves.h"

#include "scenes/core/error.h"
#include "scenes/core/numbers.h"
#include "validate/metrics/metric_registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr const char* kAll = "all";

/// The direction in which a figure becomes better.
enum class Direction { None, Higher, NearZero, Lower };

/// The key of a figure's row, without the prefix of the proxy's reference and without the light.
std::string metricKey(std::string figure) {
    constexpr std::string_view kAgainstProxy = "against_proxy.";
    if (figure.starts_with(kAgainstProxy)) figure.erase(0, kAgainstProxy.size());
    return parseFigureName(figure).key;
}

const MetricInfo* metricOf(const std::string& figure) {
    return findMetric(metricKey(figure));
}

bool isCost(const std::string& figure) {
    const MetricInfo* metric = metricOf(figure);
    return metric && isCost(*metric);
}

/// Numerators and other counts. They have no interval; the ratio computed from them has one.
bool isCount(const std::string& figure) {
    const MetricInfo* metric = metricOf(figure);
    return metric && metric->unit == Unit::PixelCount;
}

Direction directionOf(const std::string& figure) {
    const MetricInfo* metric = metricOf(figure);
    if (!metric) return Direction::None;
    if (isCost(*metric)) return Direction::Lower;
    return metric->goal == Goal::One    ? Direction::Higher
           : metric->goal == Goal::Zero ? Direction::NearZero
                                        : Direction::None;
}

/// How much worse `after` is, in the figure's unit; negative if it is better.
double worsening(Direction direction, double before, double after) {
    switch (direction) {
    case Direction::Higher:
        return before - after;
    case Direction::Lower:
        return after - before;
    case Direction::NearZero:
        return std::abs(after) - std::abs(before);
    case Direction::None:
        break;
    }
    return 0;
}

bool isEndOfInterval(const std::string& figure) {
    return figure.ends_with("_low") || figure.ends_with("_high");
}

/// Distance from a figure to the lower end of its previous interval; 0 without an interval.
double intervalBelow(const HistoryTechnique& technique, const std::string& figure, double before) {
    const auto low = technique.figures.find(figure + "_low");
    return low == technique.figures.end() ? 0.0 : std::max(0.0, before - low->second);
}

std::optional<double> valueOf(const HistoryTechnique& technique, const std::string& figure) {
    const auto found = technique.figures.find(figure);
    return found == technique.figures.end() ? std::nullopt : std::optional(found->second);
}

void judge(FigureMove& move, const HistoryTechnique& before, const Tolerances& tolerances) {
    const Direction direction = directionOf(move.figure);
    if (direction == Direction::None || !move.before) return;
    const std::optional<double> asked = tolerances.of(move.figure, *move.before);
    if ((isCost(move.figure) || isCount(move.figure)) && !asked) return;
    if (!move.after) {
        move.verdict = Verdict::Regression;
        return;
    }
    const double worse = worsening(direction, *move.before, *move.after);
    move.tolerated = asked.value_or(intervalBelow(before, move.figure, *move.before));
    move.verdict = worse <= 0                ? Verdict::Better
                   : worse <= move.tolerated ? Verdict::Tolerated
                                             : Verdict::Regression;
}

void compare(SceneMoves& result, const HistoryTechnique& before, const HistoryTechnique& after,
             const Tolerances& tolerances) {
    std::map<std::string, double> figures = before.figures;
    figures.insert(after.figures.begin(), after.figures.end());
    size_t unmoved = 0;
    for (const auto& [figure, value] : figures) {
        if (isEndOfInterval(figure)) continue;
        FigureMove move{after.name, figure, valueOf(before, figure), valueOf(after, figure)};
        if (move.before == move.after) {
            ++unmoved;
            continue;
        }
        judge(move, before, tolerances);
        result.moves.push_back(move);
    }
    result.unmoved.emplace_back(after.name, unmoved);
}

const HistoryTechnique* find(const HistoryRecord& record, const std::string& name) {
    const auto found =
        std::find_if(record.techniques.begin(), record.techniques.end(),
                     [&](const HistoryTechnique& technique) { return technique.name == name; });
    return found == record.techniques.end() ? nullptr : &*found;
}

bool comparable(const HistoryRecord& a, const HistoryRecord& b) {
    return a.scene == b.scene && a.sceneHash == b.sceneHash && a.base == b.base;
}

/// Compares a technique with those of `earlier`: comparable records, latest first.
void addTechnique(SceneMoves& result, const HistoryTechnique& now,
                  const std::vector<const HistoryRecord*>& earlier, const Tolerances& tolerances) {
    const HistoryRecord* worked = nullptr;
    const HistoryTechnique* last = nullptr;
    for (const HistoryRecord* record : earlier) {
        const HistoryTechnique* technique = find(*record, now.name);
        if (!technique) continue;
        if (!last) last = technique;
        if (technique->error.empty()) {
            worked = record;
            break;
        }
    }
    if (!last) {
        result.notes.push_back(
            fmt::format("{} is new{}", now.name, now.error.empty() ? "" : ", and fails: " + now.error));
    } else if (!now.error.empty()) {
        if (last->error.empty())
            result.failures.push_back(fmt::format("{} fails: {}", now.name, now.error));
        else
            result.notes.push_back(fmt::format("{} fails as before: {}", now.name, now.error));
    } else {
        if (!last->error.empty()) result.notes.push_back(now.name + " works again");
        if (!worked) return;
        if (worked != earlier[0])
            result.notes.push_back(
                fmt::format("{} is compared with '{}', where it last worked", now.name, worked->label));
        compare(result, *find(*worked, now.name), now, tolerances);
    }
}

void addNotes(SceneMoves& result, const HistoryRecord& now, const HistoryRecord& before) {
    for (const HistoryTechnique& technique : before.techniques)
        if (!find(now, technique.name))
            result.notes.push_back(technique.name + " is not in the latest record");
    if (now.certificate != before.certificate)
        result.notes.emplace_back(
            "the reference's own error is different (--error-px, --rate, --memory, or the machine's memory): "
            "figures change with it");
    if (now.sceneHash.empty())
        result.notes.emplace_back(
            "neither record contains the hash of its scene: the scenes may be different");
}

SceneMoves movesOf(const std::vector<HistoryRecord>& records, size_t latest, const Tolerances& tolerances) {
    const HistoryRecord& now = records[latest];
    SceneMoves result;
    result.scene = now.scene;
    result.after = now.label;
    std::vector<const HistoryRecord*> earlier;
    const HistoryRecord* other = nullptr; // the latest record of the same scene name that isn't comparable
    for (size_t i = latest; i-- > 0;) {
        if (comparable(records[i], now))
            earlier.push_back(&records[i]);
        else if (records[i].scene == now.scene && !other)
            other = &records[i];
    }
    if (earlier.empty()) {
        result.notes.push_back(
            !other ? std::string("the first record of this scene")
            : other->sceneHash != now.sceneHash
                ? fmt::format("not comparable with '{}': files or fields of the scene have changed",
                              other->label)
                : fmt::format("not comparable with '{}': its base is different", other->label));
        return result;
    }
    result.before = earlier[0]->label;
    for (const HistoryTechnique& technique : now.techniques)
        addTechnique(result, technique, earlier, tolerances);
    addNotes(result, now, *earlier[0]);
    return result;
}

} // namespace

Tolerances Tolerances::parse(const std::vector<std::string>& texts) {
    Tolerances result;
    for (const std::string& text : texts) {
        const size_t equals = text.rfind('=');
        const std::string key = text.substr(0, equals);
        Amount amount;
        std::string number = equals == std::string::npos ? "" : text.substr(equals + 1);
        if ((amount.relative = number.ends_with('%'))) number.pop_back();
        amount.value = parseNumber<double>(number).value_or(-1);
        if (amount.value < 0)
            throw InputError("--tolerance", fmt::format("found '{}'", text),
                             "FIGURE=AMOUNT, for example silhouette.iou=0.001 or depth.rmse=2%");
        if (amount.relative) amount.value /= 100;
        if (key != kAll && (directionOf(key) == Direction::None || isEndOfInterval(key))) {
            std::vector<std::string> known{kAll};
            for (const MetricInfo& metric : metricTable())
                if (const std::string name(metric.key);
                    directionOf(name) != Direction::None && !isEndOfInterval(name))
                    known.push_back(name);
            throw InputError("--tolerance", fmt::format("'{}' is not a figure that can become worse", key),
                             "all, or a figure of 'plumbline list metrics' with a best value, or of cost",
                             didYouMean(key, known));
        }
        if (!result.amounts_.emplace(key, amount).second)
            throw InputError("--tolerance", fmt::format("'{}' is given twice", key));
    }
    return result;
}

std::optional<double> Tolerances::of(const std::string& figure, double before) const {
    for (const std::string& key : {figure, metricKey(figure), std::string(kAll)}) {
        if (key == kAll && (isCost(figure) || isCount(figure))) continue;
        const auto found = amounts_.find(key);
        if (found != amounts_.end())
            return found->second.value * (found->second.relative ? std::abs(before) : 1.0);
    }
    return std::nullopt;
}

bool SceneMoves::hasRegression() const {
    return !failures.empty() || std::any_of(moves.begin(), moves.end(), [](const FigureMove& move) {
        return move.verdict == Verdict::Regression;
    });
}

std::vector<SceneMoves> latestMoves(const std::vector<HistoryRecord>& records,
                                    const std::vector<std::string>& scenes, const Tolerances& tolerances) {
    std::vector<std::string> judged;
    for (const HistoryRecord& record : records)
        if ((scenes.empty() || std::find(scenes.begin(), scenes.end(), record.scene) != scenes.end()) &&
            std::find(judged.begin(), judged.end(), record.scene) == judged.end())
            judged.push_back(record.scene);
    std::vector<SceneMoves> result;
    for (const std::string& scene : judged)
        for (size_t i = records.size(); i-- > 0;)
            if (records[i].scene == scene) {
                result.push_back(movesOf(records, i, tolerances));
                break;
            }
    return result;
}

} // namespace plumbline
