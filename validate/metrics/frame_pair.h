// Two frames of one view with the objects they show: the input of every metric.
//
// Coverage. A pixel shows the object that its `id` names (0 or NaN: none). Objects are distinguished only if
// both frames have `id`. Otherwise a pixel shows object 1 if its id is > 0 or, without `id`, if A >= 0.5.
// Pixels: row 0 = top row, index = row * width + column.
#pragma once

#include "scenes/frame/frame.h"
#include "scenes/frame/object_info.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plumbline {

class FramePair {
  public:
    /// `objects`: those of the scene, may be empty. For other ids in the frames an object is added that is
    /// named by its id and has no known properties. The frames must outlive the pair. Throws InputError if
    /// the sizes differ, a frame has neither `id` nor `A`, or an id isn't an integer from 0 to 65535.
    FramePair(const Frame& reference, const Frame& test, std::vector<ObjectInfo> objects);

    const Frame& reference() const { return *reference_; }
    const Frame& test() const { return *test_; }
    const std::vector<ObjectInfo>& objects() const { return objects_; }
    /// False if a frame has no `id`, so that everything counts as object 1.
    bool hasObjectIds() const { return hasObjectIds_; }

    /// Per pixel: id of the object shown, 0 for none.
    std::span<const int> referenceIds() const { return referenceIds_; }
    std::span<const int> testIds() const { return testIds_; }
    /// Pixels that show objects()[index] in at least one of the two frames, ascending.
    std::span<const uint32_t> pixelsOf(size_t index) const { return pixels_[index]; }

    /// Indices into objects() of those with a relief, over which pooled figures are computed. All objects if
    /// none has a relief.
    std::vector<size_t> reliefObjects() const;

    /// Empty if both frames have the channel, otherwise which of them lacks it.
    std::string missingChannel(std::string_view name) const;
    /// The same for the first of several that is missing.
    std::string missingChannel(std::span<const char* const> names) const;
    /// Empty if the reference has the channel, otherwise a sentence that it doesn't.
    std::string missingInReference(std::string_view name) const;

    /// Pixels marked in the reference's channel `uncertain`: the true image may show any of the objects or
    /// none there. Ascending; also empty if there is no such channel (see missingInReference).
    std::span<const uint32_t> uncertainPixels() const { return uncertainPixels_; }
    bool isUncertain(uint32_t pixel) const { return uncertain_[pixel]; }

  private:
    const Frame* reference_;
    const Frame* test_;
    bool hasObjectIds_ = true;
    std::vector<ObjectInfo> objects_;
    std::vector<int> referenceIds_, testIds_;
    std::vector<std::vector<uint32_t>> pixels_;
    std::vector<uint32_t> uncertainPixels_;
    std::vector<bool> uncertain_; // per pixel
};

/// Values of a channel `shadow…` from this one on are shadow. Penumbrae of other renderers are thus cut at
/// their middle.
inline constexpr float kShadowThreshold = 0.5f;
inline bool isShadow(float value) {
    return value >= kShadowThreshold;
}

/// Whether a value of a channel `uncertain…` marks the pixel. NaN does, to be safe.
inline bool saysUncertain(float value) {
    return !(value < 0.5f);
}

/// The objects a figure is computed over, as indices into FramePair::objects().
using ObjectSelection = std::span<const size_t>;

/// Upper bound of the number of pixels that show an object of the selection in either frame, to reserve
/// memory.
inline size_t maxPixelCount(const FramePair& pair, ObjectSelection selection) {
    size_t count = 0;
    for (const size_t index : selection)
        count += pair.pixelsOf(index).size();
    return count;
}

/// Calls visit(pixel, object) for every pixel that both frames cover with the same object of the selection:
/// the domain of all metrics except those of the silhouette.
template <class Visit>
void forSharedPixels(const FramePair& pair, ObjectSelection selection, Visit&& visit) {
    for (const size_t index : selection) {
        const ObjectInfo& object = pair.objects()[index];
        for (const uint32_t pixel : pair.pixelsOf(index))
            if (pair.referenceIds()[pixel] == object.id && pair.testIds()[pixel] == object.id)
                visit(pixel, object);
    }
}

/// The finite values of a channel of the test frame at the pixels that show an object of the selection; empty
/// if the frame lacks the channel.
std::vector<double> valuesOnCoveredPixels(const FramePair& pair, ObjectSelection selection,
                                          const char* channel);

} // namespace plumbline
