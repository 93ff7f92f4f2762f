#include "validate/compare/foreign_frame.h"

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

// What Blender writes as the depth of nothing: 1e10, as float and where half has cut it off.
constexpr float kNothingDepth = 1e10f, kNothingDepthHalf = 65504;
/// A renderer may sample anywhere within a pixel and filter a few pixels wide; another camera is off by far
/// more.
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

/// Settles one frame, a step a function; each says what it assumed.
class FrameSettler {
  public:
    FrameSettler(ForeignFrame& foreign, const std::optional<Camera>& camera)
        : file_(foreign.file), frame_(foreign.frame), plan_(foreign.plan), camera_(camera) {}

    std::vector<std::string> settle() {
        sayLayout();
        settleObjects();
        settleCoverage();
        settleDistance();
        settleSpace();
        return std::move(notes_);
    }

  private:
    /// The names are ours, whoever wrote the file.
    bool isOwn() const {
        return plan_.layout == FrameLayout::Own &&
               std::none_of(plan_.channels.begin(), plan_.channels.end(),
                            [](const auto& entry) { return entry.second.byUser; });
    }
    void say(const std::string& assumed) { notes_.push_back(fmt::format("{}: {}", file_, assumed)); }

    void sayLayout() {
        if (isOwn()) return;
        say(fmt::format("read as {}; {}", nameOf(plan_.layout), sourcesOf(plan_)));
    }

    /// Blender numbers no object by itself.
    void settleObjects() {
        if (plan_.layout != FrameLayout::Blender || !frame_.has("id")) return;
        const auto id = frame_.channel("id");
        if (std::any_of(id.begin(), id.end(), [](float value) { return value != 0; })) return;
        frame_.remove("id");
        say("every object has the pass index 0: they can't be told apart");
    }

    void settleCoverage() {
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

    /// Where an id or coverage is given it is believed; a depth of nothing is then no depth.
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
            say(fmt::format(
                "{} covered pixels have no depth: none that is finite, > 0 and neither 1e10 nor 65504",
                depthless));
        if (uncovered > 0)
            say(fmt::format("{} pixels have a depth but {}: they count as nothing", uncovered,
                            frame_.has("id") ? "no object's number" : "A < 0.5"));
    }

    /// Blender's A is 1 all over unless the film is transparent; its depth knows better.
    void uncoverNothing() {
        const auto coverage = frame_.channel("A"), depth = frame_.channel("Z");
        size_t count = 0;
        for (size_t pixel = 0; pixel < coverage.size(); ++pixel)
            if (coverage[pixel] >= 0.5f && isNothing(depth[pixel])) {
                coverage[pixel] = 0;
                ++count;
            }
        if (count > 0)
            say(fmt::format(
                "{} pixels have A = 1 and the depth of nothing, 1e10 or 65504: they count as nothing",
                count));
        coverById();
    }

    void coverByDepth() {
        const auto depth = frame_.channel("Z");
        cover([&](size_t pixel) { return isDepth(depth[pixel]); });
        say("has no coverage: a pixel is covered where its depth is finite, > 0 and neither 1e10 nor 65504");
    }

    void coverByPosition() {
        const auto planes = planesOf(frame_, kPosition);
        cover([&](size_t pixel) {
            const Vec3 position = vectorAt(planes, pixel);
            return std::isfinite(position.x + position.y + position.z) && position != Vec3(0);
        });
        say("has no coverage: a pixel is covered where its position isn't (0, 0, 0)");
    }

    template <class IsCovered>
    void cover(IsCovered&& isCovered) {
        covered_.resize(frame_.pixelCount());
        for (size_t pixel = 0; pixel < covered_.size(); ++pixel)
            covered_[pixel] = isCovered(pixel);
        const auto coverage = frame_.add("A");
        std::copy(covered_.begin(), covered_.end(), coverage.begin());
    }

    void settleDistance() {
        const auto source = plan_.channels.find("Z");
        if (source == plan_.channels.end() || !source->second.distanceFrom) return;
        if (!source->second.byUser && hasAll(frame_, kPosition) && camera_) {
            frame_.remove("Z");
            say("depth is that of the positions, not of the distances");
            return;
        }
        const double near = *source->second.distanceFrom;
        if (!camera_)
            throw InputError(
                file_,
                fmt::format("{} is a distance along the ray, and the camera is not known",
                            source->second.theirs),
                "a header field camera in one of the two files, as plumbline writes it",
                fmt::format("of the test frame --map \"{}=Z\" if it is planar depth", source->second.theirs));
        const CameraRays rays(*camera_);
        const Vec3 forward = glm::normalize(camera_->targetWorld - camera_->positionWorld);
        const auto depth = frame_.channel("Z");
        for (size_t pixel = 0; pixel < depth.size(); ++pixel)
            if (isDepth(depth[pixel])) {
                const auto width = static_cast<size_t>(frame_.width());
                const Ray ray = rays.ray(static_cast<double>(pixel % width) + 0.5,
                                         static_cast<double>(pixel / width) + 0.5);
                depth[pixel] = static_cast<float>(near + depth[pixel] * glm::dot(ray.direction, forward));
            }
        say(fmt::format("{} is a distance along the ray from a plane {} in front of the camera{}",
                        source->second.theirs, near,
                        source->second.byUser ? "" : ", Mitsuba's near_clip if not set"));
    }

    void settleSpace() {
        const bool positions = hasAll(frame_, kPosition), normals = hasAll(frame_, kNormal);
        if (isOwn() || (!positions && !normals)) return;
        if (!positions || !camera_) {
            say(fmt::format("{} taken as in a world with Y up, for want of {}",
                            positions ? "positions and normals are" : "normals are",
                            positions ? "a camera" : "positions to tell by"));
            return;
        }
        const auto planes = planesOf(frame_, kPosition);
        const std::optional<PositionSpace> space =
            findPositionSpace({planes[0], planes[1], planes[2]}, covered_, *camera_);
        if (!space) return; // nothing in sight
        if (!(space->medianOffsetPx <= kSameCameraPx))
            throw InputError(
                file_,
                fmt::format("its positions are {:.1f} pixels beside their own in the median",
                            space->medianOffsetPx),
                "the reference's camera, and positions in the world, in one with Z up or in pbrt's "
                "camera space");
        turn(space->worldFromTheirs, normals);
        say(fmt::format("positions{} are in {}: there they lie on their pixels' rays, {:.2f} pixels beside "
                        "in the median",
                        normals ? " and normals" : "", space->name, space->medianOffsetPx));
    }

    void turn(const Mat4& worldFromTheirs, bool normals) {
        if (worldFromTheirs == Mat4(1.0)) return;
        turnPlanes(kPosition, worldFromTheirs, 1);
        if (normals) turnPlanes(kNormal, worldFromTheirs, 0);
    }
    void turnPlanes(const std::array<std::string, 3>& channels, const Mat4& worldFromTheirs, double w) {
        const auto planes = planesOf(frame_, channels);
        for (size_t pixel = 0; pixel < frame_.pixelCount(); ++pixel) {
            const Vec4 turned = worldFromTheirs * Vec4(vectorAt(planes, pixel), w);
            for (int axis = 0; axis < 3; ++axis)
                planes[static_cast<size_t>(axis)][pixel] = static_cast<float>(turned[axis]);
        }
    }

    const std::string& file_;
    Frame& frame_;
    const ChannelPlan& plan_;
    const std::optional<Camera>& camera_;
    std::vector<bool> covered_; // per pixel; empty where nothing says it
    std::vector<std::string> notes_;
};

} // namespace

ForeignFrame readForeignFrame(const std::filesystem::path& file, std::span<const ChannelMapping> mappings) {
    ForeignFrame foreign{file.string(), {}, {}};
    ExrPlanes exr = readExr(file, [&](const std::vector<std::string>& names) {
        foreign.plan = planChannels(names, mappings, file.string());
        std::vector<std::string> wanted;
        for (const auto& [ours, source] : foreign.plan.channels)
            if (std::find(wanted.begin(), wanted.end(), source.theirs) == wanted.end())
                wanted.push_back(source.theirs);
        return wanted;
    });
    foreign.frame = Frame(exr.width, exr.height);
    for (const auto& [ours, source] : foreign.plan.channels) {
        const std::vector<float>& theirs = exr.planes.at(source.theirs);
        const float sign = source.negated ? -1.0f : 1.0f;
        std::transform(theirs.begin(), theirs.end(), foreign.frame.add(ours).begin(),
                       [&](float value) { return sign * value; });
    }
    foreign.frame.metadata = std::move(exr.attributes);
    return foreign;
}

std::vector<std::string> settleFrame(ForeignFrame& foreign, const std::optional<Camera>& camera) {
    return FrameSettler(foreign, camera).settle();
}

} // namespace plumbline
