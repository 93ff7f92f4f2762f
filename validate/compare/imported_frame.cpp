#include "validate/compare/imported_frame.h"

#include "scenes/core/error.h"
#include "scenes/frame/frame_header.h"
#include "scenes/image/exr_file.h"
#include "validate/compare/position_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {
namespace {

// The depth that Blender writes where there is no surface: 1e10 as float, clamped to 65504 as half.
constexpr float kNothingDepth = 1e10f, kNothingDepthHalf = 65504;
/// A renderer may sample anywhere within a pixel and filter over a few pixels. The offsets of another camera
/// are far larger.
constexpr double kSameCameraPx = 2;

const std::array<std::string, 3> kPosition{"P.X", "P.Y", "P.Z"}, kNormal{"N.X", "N.Y", "N.Z"};

bool hasAll(const Frame& frame, const std::array<std::string, 3>& channels) {
    return std::all_of(channels.begin(), channels.end(), [&](const auto& name) { return frame.has(name); });
}

std::array<std::span<float>, 3> planesOf(Frame& frame, const std::array<std::string, 3>& channels) {
    return {frame.channel(channels[0]), frame.channel(channels[1]), frame.channel(channels[2])};
}

Vec3 vectorAt(const std::array<std::span<float>, 3>& planes, size_t pixel) {
    return {planes[0][pixel], planes[1][pixel], planes[2][pixel]};
}

std::string sourcesOf(const ChannelPlan& plan) {
    std::string text;
    for (const auto& [ours, source] : plan.channels)
        if (source.theirs != ours || source.negated || source.distanceFrom)
            text += fmt::format("{}{} is {}{}", text.empty() ? "" : ", ", ours, source.negated ? "-" : "",
                                source.theirs);
    return text;
}

bool isNothing(float depth) {
    return depth == kNothingDepth || depth == kNothingDepthHalf;
}

bool isDepth(float depth) {
    return std::isfinite(depth) && depth > 0 && !isNothing(depth);
}

/// Converts one frame, one function for each step; each notes what it assumed.
class FrameConverter {
  public:
    FrameConverter(ImportedFrame& imported, const std::optional<Camera>& camera)
        : file_(imported.file), frame_(imported.frame), plan_(imported.plan), camera_(camera) {}

    std::vector<std::string> convert() {
        noteLayout();
        removeUnsetIds();
        convertCoverage();
        convertDistance();
        convertSpace();
        return std::move(notes_);
    }

  private:
    /// Whether the channel names are ours, regardless of which program wrote the file.
    bool isOwn() const {
        return plan_.layout == FrameLayout::Own &&
               std::none_of(plan_.channels.begin(), plan_.channels.end(),
                            [](const auto& entry) { return entry.second.byUser; });
    }
    void note(const std::string& assumed) { notes_.push_back(fmt::format("{}: {}", file_, assumed)); }

    void noteLayout() {
        if (isOwn()) return;
        note(fmt::format("read as {}; {}", nameOf(plan_.layout), sourcesOf(plan_)));
    }

    /// Blender's pass indices are 0 unless the user sets them.
    void removeUnsetIds() {
        if (plan_.layout != FrameLayout::Blender || !frame_.has("id")) return;
        const auto id = frame_.channel("id");
        if (std::any_of(id.begin(), id.end(), [](float value) { return value != 0; })) return;
        frame_.remove("id");
        note("every object has the pass index 0, so objects can't be distinguished");
    }

    void convertCoverage() {
        if (frame_.has("id") || (frame_.has("A") && !frame_.has("Z"))) {
            coverById();
            return;
        }
        if (frame_.has("A"))
            uncoverNothing();
        else if (frame_.has("Z"))
            coverByDepth();
        else if (hasAll(frame_, kPosition))
            coverByPosition();
    }

    /// Takes the coverage of the id or of A; a depth that means "no surface" becomes infinite.
    void coverById() {
        covered_.resize(frame_.pixelCount());
        const auto plane = frame_.channel(frame_.has("id") ? "id" : "A");
        for (size_t pixel = 0; pixel < covered_.size(); ++pixel)
            covered_[pixel] = plane[pixel] >= 0.5f;
        if (!frame_.has("Z") || (isOwn() && isPlumblines(frame_))) return;
        const auto depth = frame_.channel("Z");
        size_t uncovered = 0, depthless = 0;
        for (size_t pixel = 0; pixel < covered_.size(); ++pixel) {
            if (isDepth(depth[pixel])) {
                uncovered += !covered_[pixel];
                continue;
            }
            depthless += covered_[pixel];
            depth[pixel] = kInfinityF;
        }
        if (depthless > 0)
            note(fmt::format("{} covered pixels have no depth, that is, none that is finite, > 0 and neither "
                             "1e10 nor 65504",
                             depthless));
        if (uncovered > 0)
            note(fmt::format("{} pixels have a depth but {}: they count as not covered", uncovered,
                             frame_.has("id") ? "no object id" : "A < 0.5"));
    }

    /// Blender's A is 1 on the background too unless the film is transparent; its depth shows where that is.
    void uncoverNothing() {
        const auto coverage = frame_.channel("A"), depth = frame_.channel("Z");
        size_t count = 0;
        for (size_t pixel = 0; pixel < coverage.size(); ++pixel)
            if (coverage[pixel] >= 0.5f && isNothing(depth[pixel])) {
                coverage[pixel] = 0;
                ++count;
            }
        if (count > 0)
            note(fmt::format(
                "{} pixels have A = 1 and a depth of 1e10 or 65504, which mean no surface: they count as not "
                "covered",
                count));
        coverById();
    }

    void coverByDepth() {
        const auto depth = frame_.channel("Z");
        cover([&](size_t pixel) { return isDepth(depth[pixel]); });
        note("has no coverage: a pixel is covered where its depth is finite, > 0 and neither 1e10 nor 65504");
    }

    void coverByPosition() {
        const auto planes = planesOf(frame_, kPosition);
        cover([&](size_t pixel) {
            const Vec3 position = vectorAt(planes, pixel);
            return std::isfinite(position.x + position.y + position.z) && position != Vec3(0);
        });
        note("has no coverage: a pixel is covered where its position isn't (0, 0, 0)");
    }

    template <class IsCovered>
    void cover(IsCovered&& isCovered) {
        covered_.resize(frame_.pixelCount());
        for (size_t pixel = 0; pixel < covered_.size(); ++pixel)
            covered_[pixel] = isCovered(pixel);
        const auto coverage = frame_.add("A");
        std::copy(covered_.begin(), covered_.end(), coverage.begin());
    }

    void convertDistance() {
        const auto source = plan_.channels.find("Z");
        if (source == plan_.channels.end() || !source->second.distanceFrom) return;
        if (!source->second.byUser && hasAll(frame_, kPosition) && camera_) {
            frame_.remove("Z");
            note("depth is computed from the positions, not from the distances");
            return;
        }
        const double near = *source->second.distanceFrom;
        if (!camera_)
            throw InputError(file_,
                             fmt::format("{} is a distance along the ray, and the camera is not known",
                                         source->second.theirs),
                             "the header field camera in one of the two files, as plumbline writes it",
                             fmt::format("for the test frame --map \"{}=Z\" if it is planar depth",
                                         source->second.theirs));
        const CameraRays rays(*camera_);
        const Vec3 forward = glm::normalize(camera_->targetWorld - camera_->positionWorld);
        const auto depth = frame_.channel("Z");
        for (size_t pixel = 0; pixel < depth.size(); ++pixel)
            if (isDepth(depth[pixel])) {
                const Ray ray = rays.ray(pixelCenter(pixel, static_cast<size_t>(frame_.width())));
                depth[pixel] = static_cast<float>(near + depth[pixel] * glm::dot(ray.direction, forward));
            }
        note(fmt::format("{} is a distance along the ray from a plane {} in front of the camera{}",
                         source->second.theirs, near,
                         source->second.byUser ? "" : ", Mitsuba's default near_clip"));
    }

    void convertSpace() {
        const bool positions = hasAll(frame_, kPosition), normals = hasAll(frame_, kNormal);
        if (isOwn() || (!positions && !normals)) return;
        if (!positions || !camera_) {
            note(fmt::format("{} assumed to be in a world with Y up, because there {}",
                             positions ? "positions and normals are" : "normals are",
                             positions ? "is no camera to check it" : "are no positions to check it"));
            return;
        }
        const auto planes = planesOf(frame_, kPosition);
        const std::optional<PositionSpace> space =
            findPositionSpace({planes[0], planes[1], planes[2]}, covered_, *camera_);
        if (!space) return; // no pixel is covered
        if (!(space->medianOffsetPx <= kSameCameraPx))
            throw InputError(
                file_,
                fmt::format("the median distance of its positions from their pixels is {:.1f} pixels",
                            space->medianOffsetPx),
                "the reference's camera, and positions in the world, in one with Z up or in pbrt's "
                "camera space");
        transform(space->worldFromTheirs, normals);
        note(
            fmt::format("positions{} are in {}, where they lie on the rays of their pixels; median distance: "
                        "{:.2f} pixels",
                        normals ? " and normals" : "", space->name, space->medianOffsetPx));
    }

    void transform(const Mat4& worldFromTheirs, bool normals) {
        if (worldFromTheirs == Mat4(1.0)) return;
        transformPlanes(kPosition, worldFromTheirs, 1);
        if (normals) transformPlanes(kNormal, worldFromTheirs, 0);
    }
    void transformPlanes(const std::array<std::string, 3>& channels, const Mat4& worldFromTheirs, double w) {
        const auto planes = planesOf(frame_, channels);
        for (size_t pixel = 0; pixel < frame_.pixelCount(); ++pixel) {
            const Vec4 transformed = worldFromTheirs * Vec4(vectorAt(planes, pixel), w);
            for (int axis = 0; axis < 3; ++axis)
                planes[static_cast<size_t>(axis)][pixel] = static_cast<float>(transformed[axis]);
        }
    }

    const std::string& file_;
    Frame& frame_;
    const ChannelPlan& plan_;
    const std::optional<Camera>& camera_;
    std::vector<bool> covered_; // per pixel; empty if the frame has neither coverage, depth nor positions
    std::vector<std::string> notes_;
};

} // namespace

ImportedFrame readImportedFrame(const std::filesystem::path& file, std::span<const ChannelMapping> mappings) {
    ImportedFrame imported{file.string(), {}, {}};
    ExrPlanes exr = readExr(file, [&](const std::vector<std::string>& names) {
        imported.plan = planChannels(names, mappings, file.string());
        std::vector<std::string> wanted;
        for (const auto& [ours, source] : imported.plan.channels)
            if (std::find(wanted.begin(), wanted.end(), source.theirs) == wanted.end())
                wanted.push_back(source.theirs);
        return wanted;
    });
    imported.frame = Frame(exr.width, exr.height);
    for (const auto& [ours, source] : imported.plan.channels) {
        const std::vector<float>& theirs = exr.planes.at(source.theirs);
        const float sign = source.negated ? -1.0f : 1.0f;
        std::transform(theirs.begin(), theirs.end(), imported.frame.add(ours).begin(),
                       [&](float value) { return sign * value; });
    }
    imported.frame.metadata = std::move(exr.attributes);
    return imported;
}

std::vector<std::string> convertFrame(ImportedFrame& imported, const std::optional<Camera>& camera) {
    return FrameConverter(imported, camera).convert();
}

} // namespace plumbline
