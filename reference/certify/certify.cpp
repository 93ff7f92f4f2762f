#include "reference/certify/certify.h"

#include "reference/certify/edge_pieces.h"
#include "reference/certify/uncertain.h"
#include "scenes/core/nearest_rank.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plumbline {

namespace {

/// By nearest rank. Reorders; 0 of none.
double percentile(std::vector<float>& values, unsigned percent) {
    if (values.empty()) return 0;
    return nearestRankInPlace(values, percent);
}

class UncertainMarker {
  public:
    UncertainMarker(const Scene& scene, const std::vector<TracedObject>& objects, const EmbreeScene& embree,
                    const FrameEvidence& evidence, Frame& frame)
        : scene_(scene), embree_(embree), evidence_(evidence),
          frame_(frame), positions_{frame.channel("P.X"), frame.channel("P.Y"), frame.channel("P.Z")} {
        contours_.reserve(objects.size());
        for (const TracedObject& object : objects)
            contours_.emplace_back(*object.mesh);
    }

    void mark() {
        markCoverage();
        for (size_t i = 0; i < scene_.lights.size(); ++i)
            markShadow(i);
    }

  private:
    Vec3 positionOf(size_t pixel) const {
        return {positions_[0][pixel], positions_[1][pixel], positions_[2][pixel]};
    }

    void markCoverage() {
        const std::span<float> uncertain = frame_.add("uncertain");
        otherSheet_.assign(frame_.pixelCount(), 0);
        for (size_t pixel = 0; pixel < frame_.pixelCount(); ++pixel)
            if (evidence_.otherObject[pixel]) uncertain[pixel] = otherSheet_[pixel] = 1;
        markUncertainCoverage(scene_.camera, contours_, embree_, frame_.channel("id"), uncertain,
                              otherSheet_);
    }

    void markShadow(size_t light) {
        const std::string& name = scene_.lights[light].name;
        const std::span<float> uncertain = frame_.add(uncertainShadowChannel(name));
        const std::span<const float> shadow = frame_.channel(shadowChannel(name));
        std::vector<ShadowPoint> points;
        for (size_t pixel = 0; pixel < frame_.pixelCount(); ++pixel) {
            if (std::isnan(shadow[pixel])) continue;
            // Another place may be seen there, and that one's shadow isn't known.
            const uint8_t by = evidence_.shadowBy[light][pixel];
            if (evidence_.ambiguous[pixel] || otherSheet_[pixel] != 0 || by == FrameEvidence::kNearRay)
                uncertain[pixel] = 1;
            else if (by == FrameEvidence::kRay)
                points.push_back({static_cast<uint32_t>(pixel), positionOf(pixel),
                                  evidence_.errorWorld[pixel], shadow[pixel] != 0});
        }
        markUncertainShadow(scene_.lights[light], contours_, embree_, points, uncertain);
    }

    const Scene& scene_;
    const EmbreeScene& embree_;
    const FrameEvidence& evidence_;
    Frame& frame_;
    std::array<std::span<const float>, 3> positions_;
    std::vector<ContourFinder> contours_; // per object
    std::vector<float> otherSheet_;
};

} // namespace

std::vector<float> errorsPx(const Camera& camera, const FrameEvidence& evidence, const Frame& frame) {
    const Screen screen = Screen::ofCamera(camera);
    const auto x = frame.channel("P.X"), y = frame.channel("P.Y"), z = frame.channel("P.Z"),
               id = frame.channel("id");
    std::vector<float> errors(frame.pixelCount(), 0);
    for (size_t pixel = 0; pixel < errors.size(); ++pixel)
        if (id[pixel] != 0)
            errors[pixel] =
                static_cast<float>(evidence.errorWorld[pixel] *
                                   screen.pixelsPerWorld(screen.project({x[pixel], y[pixel], z[pixel]})));
    return errors;
}

void measureCertificate(const Frame& frame, const FrameEvidence& evidence, const std::vector<float>& errorsPx,
                        Certificate& certificate) {
    const auto id = frame.channel("id");
    std::vector<float> world, px;
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel) {
        if (id[pixel] == 0) continue;
        world.push_back(evidence.errorWorld[pixel]);
        px.push_back(errorsPx[pixel]);
    }
    certificate.worldP50 = percentile(world, 50);
    certificate.worldP99 = percentile(world, 99);
    certificate.worldMax = percentile(world, 100);
    certificate.pxP50 = percentile(px, 50);
    certificate.pxP99 = percentile(px, 99);
    certificate.pxMax = percentile(px, 100);
}

FaceErrorsPx measureFaces(const std::vector<TracedObject>& objects, const Frame& frame,
                          const FrameEvidence& evidence, const std::vector<float>& errorsPx) {
    std::vector<std::vector<std::vector<float>>> errors; // per object, per face
    for (const TracedObject& object : objects)
        errors.emplace_back(lengthOf(object.surface->mesh().faceCount()));
    const auto id = frame.channel("id");
    for (size_t pixel = 0; pixel < errorsPx.size(); ++pixel)
        if (id[pixel] != 0)
            item(errors[static_cast<size_t>(id[pixel]) - 1], evidence.face[pixel]).push_back(errorsPx[pixel]);
    FaceErrorsPx result;
    for (auto& ofObject : errors) {
        result.emplace_back();
        for (std::vector<float>& ofFace : ofObject)
            result.back().push_back(static_cast<float>(percentile(ofFace, 99)));
    }
    return result;
}

void markUncertain(const Scene& scene, const std::vector<TracedObject>& objects, const EmbreeScene& embree,
                   const FrameEvidence& evidence, Frame& frame) {
    UncertainMarker(scene, objects, embree, evidence, frame).mark();
}

} // namespace plumbline
