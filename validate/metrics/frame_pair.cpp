#include "validate/metrics/frame_pair.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline {
namespace {

ObjectInfo unknownObject(int id, std::string name) {
    ObjectInfo object;
    object.id = id;
    object.name = std::move(name);
    return object;
}

void checkFrame(const Frame& frame, const char* which) {
    if (!frame.has("id") && !frame.has("A"))
        throw InputError(which, "the frame has no channel that contains its coverage",
                         "a channel A (coverage, 0 or 1) or id (id of the object, 0 for none)");
}

/// Id of the object at each pixel. If `byId` is false, 1 at all covered pixels.
std::vector<int> readIds(const Frame& frame, bool byId, const char* which) {
    std::vector<int> ids(frame.pixelCount(), 0);
    if (!frame.has("id")) {
        const auto coverage = frame.channel("A");
        for (size_t pixel = 0; pixel < ids.size(); ++pixel)
            ids[pixel] = coverage[pixel] >= 0.5f ? 1 : 0;
        return ids;
    }
    const auto plane = frame.channel("id");
    for (size_t pixel = 0; pixel < ids.size(); ++pixel) {
        const float value = plane[pixel];
        if (std::isnan(value)) continue; // nothing there
        const bool inRange = value >= 0 && value <= kLargestId;
        const int id = inRange ? static_cast<int>(value) : 0;
        if (!inRange || static_cast<float>(id) != value)
            throw InputError(fmt::format("{}: channel id", which),
                             fmt::format("the value {} at pixel ({}, {}) is not the id of an object", value,
                                         pixel % static_cast<size_t>(frame.width()),
                                         pixel / static_cast<size_t>(frame.width())),
                             fmt::format("integers from 0 (nothing) to {}", kLargestId));
        ids[pixel] = byId ? id : static_cast<int>(id > 0);
    }
    return ids;
}

} // namespace

FramePair::FramePair(const Frame& reference, const Frame& test, std::vector<ObjectInfo> objects)
    : reference_(&reference), test_(&test), objects_(std::move(objects)) {
    if (reference.width() != test.width() || reference.height() != test.height())
        throw InputError("compare",
                         fmt::format("the reference is {} x {} pixels, the test {} x {}", reference.width(),
                                     reference.height(), test.width(), test.height()),
                         "two frames of the same size");
    checkFrame(reference, "reference");
    checkFrame(test, "test");
    hasObjectIds_ = reference.has("id") && test.has("id");
    referenceIds_ = readIds(reference, hasObjectIds_, "reference");
    testIds_ = readIds(test, hasObjectIds_, "test");

    if (!hasObjectIds_) {
        // One object represents all. Its properties are known only if the scene has a single object.
        if (objects_.size() == 1)
            objects_[0].id = 1;
        else
            objects_ = {unknownObject(1, "everything")};
    }
    // By id: the index of the object plus 1, or 0 if there is none.
    std::vector<size_t> numberOf(kLargestId + 1);
    for (size_t i = objects_.size(); i-- > 0;) // the first of two with the same id
        if (objects_[i].id > 0 && objects_[i].id <= kLargestId)
            numberOf[static_cast<size_t>(objects_[i].id)] = i + 1;
    std::vector<bool> shown(kLargestId + 1);
    for (const std::vector<int>* ids : {&referenceIds_, &testIds_})
        for (const int id : *ids)
            shown[static_cast<size_t>(id)] = true;
    for (int id = 1; id <= kLargestId; ++id)
        if (shown[static_cast<size_t>(id)] && numberOf[static_cast<size_t>(id)] == 0) {
            objects_.push_back(unknownObject(id, fmt::format("object {}", id)));
            numberOf[static_cast<size_t>(id)] = objects_.size();
        }

    pixels_.resize(objects_.size());
    const auto list = [&](int id, uint32_t pixel) {
        pixels_[numberOf[static_cast<size_t>(id)] - 1].push_back(pixel);
    };
    for (uint32_t pixel = 0; pixel < referenceIds_.size(); ++pixel) {
        const int inReference = referenceIds_[pixel], inTest = testIds_[pixel];
        if (inReference > 0) list(inReference, pixel);
        if (inTest > 0 && inTest != inReference) list(inTest, pixel);
    }

    uncertain_.resize(referenceIds_.size());
    if (!reference.has("uncertain")) return;
    const auto plane = reference.channel("uncertain");
    for (uint32_t pixel = 0; pixel < referenceIds_.size(); ++pixel) {
        uncertain_[pixel] = saysUncertain(plane[pixel]);
        if (uncertain_[pixel]) uncertainPixels_.push_back(pixel);
    }
}

std::vector<size_t> FramePair::reliefObjects() const {
    std::vector<size_t> all, relief;
    for (size_t i = 0; i < objects_.size(); ++i) {
        all.push_back(i);
        if (objects_[i].hasRelief()) relief.push_back(i);
    }
    return relief.empty() ? all : relief;
}

std::string FramePair::missingChannel(std::string_view name) const {
    const bool inReference = reference_->has(name), inTest = test_->has(name);
    if (inReference && inTest) return {};
    const char* which = inReference ? "the test frame has"
                        : inTest    ? "the reference frame has"
                                    : "neither frame has";
    return fmt::format("{} {} channel {}", which, inReference || inTest ? "no" : "a", name);
}

std::string FramePair::missingChannel(std::span<const char* const> names) const {
    for (const char* name : names)
        if (std::string missing = missingChannel(name); !missing.empty()) return missing;
    return {};
}

std::string FramePair::missingInReference(std::string_view name) const {
    return reference_->has(name) ? std::string() : fmt::format("the reference frame has no channel {}", name);
}

std::vector<double> valuesOnCoveredPixels(const FramePair& pair, ObjectSelection selection,
                                          const char* channel) {
    std::vector<double> values;
    if (!pair.test().has(channel)) return values;
    const auto plane = pair.test().channel(channel);
    values.reserve(maxPixelCount(pair, selection));
    for (const size_t index : selection)
        for (const uint32_t pixel : pair.pixelsOf(index))
            if (pair.testIds()[pixel] == pair.objects()[index].id && std::isfinite(plane[pixel]))
                values.push_back(plane[pixel]);
    return values;
}

} // namespace plumbline
