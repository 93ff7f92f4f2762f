// Two frames of one view with the objects they show: the only thing a metric gets to see.
//
// Coverage. A pixel shows the object named by its `id` (0 or NaN: nothing). Where only one frame of the pair
// has `id`, or none, objects can't be told apart: a pixel then shows object 1 if its id is > 0 or, without an
// id, if A >= 0.5. Pixels: row 0 = top row, index = row * width + column.
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
    /// `objects`: those of the scene, may be empty; ids the frames show beyond them are added by number, with
    /// nothing known about them. The frames must outlive the pair. Throws InputError if the sizes differ, a
    /// frame has neither `id` nor `A`, or an id isn't a whole number from 0 to 65535.
    FramePair(const Frame& reference, const Frame& test, std::vector<ObjectInfo> objects);

    const Frame& reference() const { return *reference_; }
    const Frame& test() const { return *test_; }
    const std::vector<ObjectInfo>& objects() const { return objects_; }
    /// False where `id` was missing and everything counts as object 1.
    bool objectsToldApart() const { return toldApart_; }

    /// Per pixel: id of the object shown, 0 for none.
    std::span<const int> referenceIds() const { return referenceIds_; }
    std::span<const int> testIds() const { return testIds_; }
    /// Pixels that show objects()[index] in at least one of the two frames, ascending.
    std::span<const uint32_t> pixelsOf(size_t index) const { return pixels_[index]; }

    /// Indices into objects() of those with a relief: what "pooled" means. All of them if none has one.
    std::vector<size_t> reliefObjects() const;

    /// Empty if both frames have the channel, else which of them lacks it.
    std::string missingChannel(std::string_view name) const;
    /// The same of several: of the first that is missing.
    std::string missingChannel(std::span<const char* const> names) const;
    /// Empty if the reference has the channel, else a sentence that it hasn't.
    std::string missingInReference(std::string_view name) const;

    /// Pixels at which the true image may show any of the objects or none, whatever the reference shows: its
    /// channel `uncertain`. Ascending; empty also where it has no such channel (see missingInReference).
    std::span<const uint32_t> uncertainPixels() const { return uncertainPixels_; }
    bool isUncertain(uint32_t pixel) const { return uncertain_[pixel]; }

  private:
    const Frame* reference_;
    const Frame* test_;
    bool toldApart_ = true;
    std::vector<ObjectInfo> objects_;
    std::vector<int> referenceIds_, testIds_;
    std::vector<std::vector<uint32_t>> pixels_;
    std::vector<uint32_t> uncertainPixels_;
    std::vector<bool> uncertain_; // per pixel
};

/// A value of a channel `shadow…` from here on is shadow: another renderer's penumbra is cut at its middle.
inline constexpr float kShadowThreshold = 0.5f;
inline bool isShadow(float value) {
    return value >= kShadowThreshold;
}

/// Whether a value of a channel `uncertain…` says so. One that is no number can't rule it out.
inline bool saysUncertain(float value) {
    return !(value < 0.5f);
}

/// The objects a figure is computed over, as indices into FramePair::objects().
using ObjectSelection = std::span<const size_t>;

/// Pixels that show one of them in either frame: room for a value each of what is collected over them.
inline size_t mostPixels(const FramePair& pair, ObjectSelection selection) {
    size_t count = 0;
    for (const size_t index : selection)
        count += pair.pixelsOf(index).size();
    return count;
}

/// Calls visit(pixel, object) for every pixel that both frames cover with the same object of the selection:
/// the domain of every metric but the silhouette's.
template <class Visit>
void forSharedPixels(const FramePair& pair, ObjectSelection selection, Visit&& visit) {
    for (const size_t index : selection) {
        const ObjectInfo& object = pair.objects()[index];
        for (const uint32_t pixel : pair.pixelsOf(index))
            if (pair.referenceIds()[pixel] == object.id && pair.testIds()[pixel] == object.id)
                visit(pixel, object);
    }
}

/// The finite values of a channel of the test frame where that frame shows an object of the selection; none
/// if it lacks the channel.
std::vector<double> valuesOnCoveredPixels(const FramePair& pair, ObjectSelection selection,
                                          const char* channel);

} // namespace plumbline
