#include "reference/rates/rate.h"

#include "reference/rates/face_error.h"
#include "reference/rates/face_role.h"
#include "scenes/core/error.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace plumbline {

namespace {

// Error factor allowed for faces that only cast shadows; the certificate marks uncertain shadow pixels in any
// case.
constexpr double kCasterSlack = 4;
// Doubling a rate reduces the error by a factor between 2 and 4. A face that is too coarse is refined by the
// number of doublings computed with the geometric mean of both factors.
constexpr double kFallPerRung = 2.8;
// Texels per cell at the initial rate: coarse enough for maps finer than the image, fine enough that few
// texels are in cells whose error isn't measured.
constexpr double kFirstTexels = 2;
// Once cells are smaller than half a texel and the face has kRegularRate of them, two doublings must reduce
// the error below this fraction, or the face isn't refined further. On coarser lattices bows don't fall
// regularly.
constexpr double kFalling = 0.7;
constexpr int kRegularRate = 16;
// Doubling the rate along one axis only is preferred if it reduces the error below this fraction.
constexpr double kWorthAlone = 0.6;

/// `value` >= 0; at most kMaxRate.
int powerOfTwoAtLeast(double value) {
    return static_cast<int>(
        std::bit_ceil(static_cast<unsigned>(std::ceil(std::min<double>(value, kMaxRate)))));
}

double bytesOf(uint64_t microTriangles) {
    return kBytesPerMicroTriangle * static_cast<double>(microTriangles);
}

/// The possible rates of a face, from coarse to fine, with their errors.
struct Ladder {
    struct Rung {
        Vec2i rate;
        double errorPx;
        PatchRegion region; // region in which the error was measured
    };
    std::vector<Rung> rungs;
    bool ended = false; // no finer rate reduces the error
    size_t lowest = 0;  // lower rungs were too coarse in a run

    /// Index of the coarsest rung that meets the target error, or of the finest rung.
    size_t indexFor(double aimPx) const {
        for (size_t i = lowest; i < rungs.size(); ++i)
            if (rungs[i].errorPx <= aimPx) return i;
        return rungs.size() - 1;
    }
    const Rung& rungFor(double aimPx) const { return rungs[indexFor(aimPx)]; }
    bool reaches(double aimPx) const { return lowest < rungs.size() && rungFor(aimPx).errorPx <= aimPx; }
};

/// Builds the ladders of one object's faces.
class LadderBuilder {
  public:
    LadderBuilder(const PlannedObject& object, std::vector<FacePlace> places, double casterPixelsPerWorld)
        : surface_(*object.surface), relief_(object.relief), probe_(*object.surface, object.relief),
          places_(std::move(places)), casterPixelsPerWorld_(casterPixelsPerWorld) {}

    /// Adds finer rates until the error is at most the target.
    void extend(std::vector<Ladder>& ladders, double errorPx) const {
        ladders.resize(places_.size());
        tbb::parallel_for(tbb::blocked_range<int>(0, countOf(places_)), [&](const auto& faces) {
            BaseSurface::Evaluator evaluator(surface_);
            for (int face = faces.begin(); face < faces.end(); ++face)
                if (surface_.hasLimit(face)) extend(item(ladders, face), face, errorPx, evaluator);
        });
    }

  private:
    double pixelsPerWorld(int face) const {
        switch (item(places_, face).role) {
        case FaceRole::Seen:
            return item(places_, face).pixelsPerWorld;
        case FaceRole::Casts:
            return casterPixelsPerWorld_ / kCasterSlack;
        default:
            return 0;
        }
    }

    void extend(Ladder& ladder, int face, double errorPx, BaseSurface::Evaluator& evaluator) const {
        const double scale = pixelsPerWorld(face);
        if (ladder.rungs.empty()) ladder.rungs.push_back(lowestRung(face, scale, errorPx, evaluator));
        const auto rungAt = [&](const Vec2i& rate) {
            const MeasuredError error = probe_.worstWithin(ladder.rungs.back().region, face, rate, evaluator);
            return Ladder::Rung{rate, scale * error.world, error.region};
        };
        while (!ladder.reaches(errorPx) && !ladder.ended) {
            const Ladder::Rung next = finer(ladder.rungs.back(), face, rungAt);
            const size_t count = ladder.rungs.size();
            const bool gainsLittle = count >= 2 && isWithinTexels(ladder.rungs[count - 2].rate, face) &&
                                     next.errorPx > kFalling * ladder.rungs[count - 2].errorPx;
            if (next.rate == ladder.rungs.back().rate || gainsLittle)
                ladder.ended = true; // the finest rate, a pole or a tear
            else
                ladder.rungs.push_back(next);
        }
        ladder.lowest = std::min(ladder.lowest, ladder.rungs.size() - 1);
    }

    Ladder::Rung lowestRung(int face, double scale, double errorPx, BaseSurface::Evaluator& evaluator) const {
        Vec2i rate(probe_.smallestRate(face));
        if (scale == 0) return {rate, 0, {}};
        if (relief_ &&
            scale * relief_->depth * (relief_->map->maxDepth() - relief_->map->minDepth()) > errorPx) {
            const Vec2 cells = probe_.texelsAcross(face) / kFirstTexels;
            rate = glm::max(rate, Vec2i(powerOfTwoAtLeast(cells.x), powerOfTwoAtLeast(cells.y)));
        }
        const MeasuredError error = probe_.typicalWorst(face, rate, evaluator);
        return {rate, scale * error.world, error.region};
    }

    /// Whether a cell is at most half a texel large, and small on the face; from there on errors decrease
    /// with the rate.
    bool isWithinTexels(const Vec2i& rate, int face) const {
        const Vec2 texels = probe_.texelsAcross(face);
        return rate.x >= 2 * texels.x && rate.y >= 2 * texels.y && std::max(rate.x, rate.y) >= kRegularRate;
    }

    /// The next rate: doubles one axis if that gains nearly as much as doubling both, trying the axis with
    /// more texels per cell first.
    template <typename RungAt>
    Ladder::Rung finer(const Ladder::Rung& here, int face, RungAt rungAt) const {
        const Vec2i doubled = glm::min(here.rate * 2, Vec2i(kMaxRate));
        if (doubled == here.rate) return here;
        const Ladder::Rung both = rungAt(doubled);
        if (!probe_.isSquare(face)) return both;
        const Vec2 texels = probe_.texelsAcross(face) / Vec2(here.rate);
        Vec2i choices[2] = {{doubled.x, here.rate.y}, {here.rate.x, doubled.y}};
        if (texels.y > texels.x || (texels.x == texels.y && here.rate.y < here.rate.x))
            std::swap(choices[0], choices[1]);
        for (const Vec2i& alone : choices) {
            if (alone == doubled || alone == here.rate) continue;
            const Ladder::Rung rung = rungAt(alone);
            if (rung.errorPx <= std::max(kWorthAlone * here.errorPx, both.errorPx)) return rung;
        }
        return both;
    }

    const BaseSurface& surface_;
    const Relief* relief_;
    FaceErrorProbe probe_;
    std::vector<FacePlace> places_; // per face
    double casterPixelsPerWorld_;
};

std::vector<int> largestRates(const RatePlan& plan) {
    std::vector<int> largest;
    for (const Rates& rates : plan.rates)
        largest.push_back(largestRate(rates));
    return largest;
}

std::string nameOf(uint64_t memoryBytes) {
    return fmt::format("--memory {} MB", memoryBytes >> 20);
}

} // namespace

struct RatePlanner::Impl {
    std::vector<PlannedObject> objects;
    double errorPx;
    uint64_t memoryBytes;
    std::vector<LadderBuilder> builders;      // per object
    std::vector<std::vector<Ladder>> ladders; // per object, per face

    RatePlan ratesFor(double aimPx) const {
        RatePlan plan;
        for (size_t i = 0; i < objects.size(); ++i) {
            std::vector<Vec2i> faces(ladders[i].size(), Vec2i(1));
            for (size_t face = 0; face < faces.size(); ++face)
                if (!ladders[i][face].rungs.empty()) faces[face] = ladders[i][face].rungFor(aimPx).rate;
            plan.rates.push_back(ratesFromFaces(*objects[i].surface, std::move(faces)));
        }
        count(plan);
        return plan;
    }

    template <typename Visit>
    void forEachLadder(Visit visit) const {
        for (const auto& ofObject : ladders)
            for (const Ladder& ladder : ofObject)
                if (!ladder.rungs.empty()) visit(ladder);
    }

    bool fits(const RatePlan& plan) const {
        return bytesOf(plan.microTriangles) <= static_cast<double>(memoryBytes);
    }

    /// Limits all rates and halves the limit until the plan fits into memory.
    void giveUpTexels(RatePlan& plan) const {
        for (int most = kMaxRate / 2; most >= 1 && !fits(plan); most /= 2) {
            for (size_t i = 0; i < objects.size(); ++i) {
                std::vector<Vec2i> faces = plan.rates[i].faces;
                for (const BaseSurface::Patch& patch : objects[i].surface->patches()) {
                    Vec2i& rate = item(faces, patch.face);
                    rate = glm::min(rate, Vec2i(patch.subFace ? std::max(most, 2) : most));
                }
                plan.rates[i] = ratesFromFaces(*objects[i].surface, std::move(faces));
            }
            count(plan);
        }
    }

    void count(RatePlan& plan) const {
        plan.microTriangles = 0;
        for (size_t i = 0; i < objects.size(); ++i)
            plan.microTriangles += microMeshSize(*objects[i].surface, plan.rates[i]).microTriangles;
    }
};

RatePlanner::RatePlanner(const Scene& scene, std::vector<PlannedObject> objects, double errorPx,
                         uint64_t memoryBytes)
    : impl_(std::make_unique<Impl>()) {
    assert(errorPx > 0);
    impl_->objects = std::move(objects);
    impl_->errorPx = errorPx;
    impl_->memoryBytes = memoryBytes;
    double nearest = 0;
    std::vector<std::vector<FacePlace>> places;
    for (const PlannedObject& object : impl_->objects) {
        places.push_back(placeFaces(scene, *object.surface, object.relief));
        for (const FacePlace& place : places.back())
            nearest = std::max(nearest, place.pixelsPerWorld);
    }
    impl_->ladders.resize(impl_->objects.size());
    for (size_t i = 0; i < impl_->objects.size(); ++i) {
        impl_->builders.emplace_back(impl_->objects[i], std::move(places[i]), nearest);
        impl_->builders[i].extend(impl_->ladders[i], errorPx);
    }
}
RatePlanner::~RatePlanner() = default;

bool RatePlanner::refine(const FaceErrorsPx& measured) {
    bool finer = false;
    const double aimPx = impl_->errorPx;
    for (size_t i = 0; i < impl_->objects.size(); ++i) {
        std::vector<Ladder>& ladders = impl_->ladders[i];
        std::vector<Vec2i> before;
        for (size_t face = 0; face < ladders.size(); ++face) {
            Ladder& ladder = ladders[face];
            before.push_back(ladder.rungs.empty() ? Vec2i(0) : ladder.rungFor(aimPx).rate);
            if (ladder.rungs.empty() || measured[i][face] <= aimPx) continue;
            const auto rungs = std::ceil(std::log(measured[i][face] / aimPx) / std::log(kFallPerRung));
            ladder.lowest = ladder.indexFor(aimPx) + static_cast<size_t>(rungs);
        }
        impl_->builders[i].extend(ladders, aimPx);
        for (size_t face = 0; face < ladders.size(); ++face)
            finer |= !ladders[face].rungs.empty() && ladders[face].rungFor(aimPx).rate != before[face];
    }
    return finer;
}

RatePlan RatePlanner::plan() const {
    const Impl& impl = *impl_;
    RatePlan plan = impl.ratesFor(impl.errorPx);
    const std::vector<int> wanted = largestRates(plan);
    double worst = 0;
    impl.forEachLadder([&](const Ladder& ladder) { worst = std::max(worst, ladder.rungs.front().errorPx); });
    if (!impl.fits(plan)) {
        for (double aim = 2 * impl.errorPx; !impl.fits(plan) && aim < 2 * worst; aim *= 2)
            plan = impl.ratesFor(aim);
        impl.giveUpTexels(plan);
        if (!impl.fits(plan))
            throw MachineError(
                "--memory",
                fmt::format("{} MB don't hold the scene even at its coarsest tessellation",
                            impl.memoryBytes >> 20),
                fmt::format("at least {:.0f} MB", bytesOf(plan.microTriangles) / (1 << 20) + 1));
        plan.limit = nameOf(impl.memoryBytes);
    }
    plan.wanted = wanted;
    return plan;
}

RatePlan planUniformRate(const std::vector<PlannedObject>& objects, int rate, uint64_t memoryBytes) {
    if (!isRate(rate))
        throw InputError("--rate", fmt::format("found {}", rate),
                         fmt::format("a power of two from 1 to {}", kMaxRate));
    RatePlan plan;
    for (const PlannedObject& object : objects) {
        plan.rates.push_back(uniformRates(*object.surface, rate));
        plan.microTriangles += microMeshSize(*object.surface, plan.rates.back()).microTriangles;
    }
    // A requested rate is used exactly or rejected, never silently changed.
    if (bytesOf(plan.microTriangles) > static_cast<double>(memoryBytes))
        throw MachineError("--rate", fmt::format("rate {} doesn't fit {}", rate, nameOf(memoryBytes)),
                           "a smaller rate or more memory");
    plan.wanted = largestRates(plan);
    plan.limit = fmt::format("--rate {}", rate);
    return plan;
}

} // namespace plumbline
