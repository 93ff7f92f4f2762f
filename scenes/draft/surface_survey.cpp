#include "scenes/draft/surface_survey.h"

#include "scenes/core/error.h"
#include "scenes/surface/limit_check.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plumbline {
namespace {

/// Approximate number of pieces: enough for stable medians, few enough to take 0.1 s.
constexpr int kWantedPieces = 40000;
constexpr int kFinestRate = 16;
constexpr double kTightShare = 0.05;
/// Tolerance for normals that differ only by rounding: the length of their mean is 1 minus half the square of
/// their spread.
constexpr double kFlatness = 1e-9;

/// Segments per control edge: a power of two (PLATFORM: dyadic samples lie on the limit surface).
int surveyRate(int patchCount) {
    int rate = 1;
    while (rate < kFinestRate && patchCount * 4.0 * rate * rate <= kWantedPieces)
        rate *= 2;
    return rate;
}

struct Weighted {
    double value, area;
};

/// Smallest value with at least `share` of the area at or below it.
double weightedQuantile(std::vector<Weighted> values, double share) {
    std::ranges::sort(values, {}, &Weighted::value);
    double total = 0, sum = 0;
    for (const Weighted& entry : values)
        total += entry.area;
    for (const Weighted& entry : values)
        if ((sum += entry.area) >= share * total) return entry.value;
    return values.back().value;
}

/// World units per unit of u and of v at a sample; nothing where the texture parametrization is singular.
std::optional<Vec2> uvScaleAt(const BaseSample& sample) {
    const double determinant = sample.uvU.x * sample.uvV.y - sample.uvU.y * sample.uvV.x;
    // Inverse of [uvU uvV], column by column: the patch coordinates' change by a unit of u and of v.
    const Vec3 byU = (sample.positionU * sample.uvV.y - sample.positionV * sample.uvU.y) / determinant;
    const Vec3 byV = (sample.positionV * sample.uvU.x - sample.positionU * sample.uvV.x) / determinant;
    const Vec2 scale(glm::length(byU), glm::length(byV));
    if (!std::isfinite(scale.x) || !std::isfinite(scale.y) || !(scale.x > 0) || !(scale.y > 0)) return {};
    return scale;
}

/// The larger principal curvature, positive where the surface curves away from its normal, as a sphere does.
/// It follows from the first and second fundamental forms (do Carmo, Differential Geometry of Curves and
/// Surfaces, 3-3); the derivatives of n give -II.
double outwardCurvature(const BaseSample& sample) {
    const double e = glm::dot(sample.positionU, sample.positionU),
                 f = glm::dot(sample.positionU, sample.positionV),
                 g = glm::dot(sample.positionV, sample.positionV);
    const double l = glm::dot(sample.normalU, sample.positionU),
                 n = glm::dot(sample.normalV, sample.positionV);
    const double m =
        0.5 * (glm::dot(sample.normalU, sample.positionV) + glm::dot(sample.normalV, sample.positionU));
    const double gram = e * g - f * f;
    const double mean = 0.5 * (e * n - 2 * f * m + g * l) / gram, gauss = (l * n - m * m) / gram;
    return mean + std::sqrt(std::max(mean * mean - gauss, 0.0));
}

class Survey {
  public:
    Survey(const ControlMesh& mesh, Scheme scheme) : surface_(mesh, scheme), evaluator_(surface_) {}

    SurfaceSurvey take() {
        result_.patchCount = countOf(surface_.patches());
        const int rate = surveyRate(result_.patchCount);
        for (int face = 0; face < surface_.mesh().faceCount(); ++face)
            if (surface_.hasLimit(face)) addFace(surface_.tessellateFace(face, rate));
        if (result_.pieces.empty())
            throw InputError(surface_.mesh().name, "no face of it is part of the surface",
                             "a face that is no hole and does more than support others");
        summarize();
        return std::move(result_);
    }

  private:
    void addFace(const BaseSurface::FaceTessellation& cut) {
        std::vector<BaseSample> samples;
        for (const auto& place : cut.samples) {
            evaluator_.setPatch(place.patch);
            const BaseSample sample = evaluator_.sample(place.u, place.v);
            samples.push_back(sample);
            result_.samples.push_back(static_cast<const BasePoint&>(sample));
            result_.bounds.add(sample.position);
        }
        for (const std::array<int, 4>& facet : cut.facets)
            addFacet(samples, facet);
    }

    void addFacet(const std::vector<BaseSample>& samples, const std::array<int, 4>& facet) {
        const auto at = [&](size_t corner) -> const BaseSample& { return item(samples, facet[corner]); };
        const size_t corners = facet[3] < 0 ? 3 : 4;
        Vec3 areaVector = glm::cross(at(1).position - at(0).position, at(2).position - at(0).position);
        if (corners == 4)
            areaVector += glm::cross(at(2).position - at(0).position, at(3).position - at(0).position);
        const double area = 0.5 * glm::length(areaVector);
        if (!(area > 0)) return;
        result_.pieces.push_back({areaVector / (2 * area), area});
        for (size_t corner = 0; corner < corners; ++corner)
            addSample(at(corner), area / static_cast<double>(corners));
    }

    void addSample(const BaseSample& sample, double area) {
        if (sample.singular) return; // its derivatives say nothing about lengths and curvatures
        if (const std::optional<Vec2> scale = uvScaleAt(sample)) {
            scalesU_.push_back({scale->x, area});
            scalesV_.push_back({scale->y, area});
        }
        const double curvature = outwardCurvature(sample);
        if (!std::isnan(curvature)) radii_.push_back({curvature > 0 ? 1 / curvature : kInfinity, area});
    }

    void summarize() {
        Vec3 meanNormal(0);
        for (const SurfacePiece& piece : result_.pieces) {
            result_.area += piece.area;
            meanNormal += piece.normal * piece.area;
        }
        result_.flat = glm::length(meanNormal) >= (1 - kFlatness) * result_.area;
        if (!scalesU_.empty())
            result_.uvScale = Vec2(weightedQuantile(scalesU_, 0.5), weightedQuantile(scalesV_, 0.5));
        if (!radii_.empty()) result_.tightRadius = weightedQuantile(radii_, kTightShare);
    }

    BaseSurface surface_;
    BaseSurface::Evaluator evaluator_;
    SurfaceSurvey result_;
    std::vector<Weighted> scalesU_, scalesV_, radii_;
};

} // namespace

SurfaceSurvey surveySurface(const ControlMesh& mesh, Scheme scheme) {
    assert(mesh.hasUvs());
    checkControlMesh(mesh, scheme);
    if (scheme != Scheme::None) checkLimitTopology(mesh);
    return Survey(mesh, scheme).take();
}

} // namespace plumbline
