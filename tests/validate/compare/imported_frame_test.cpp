// Frames in the layouts of other renderers' documentation and sources, of a sphere with known values:
//   Blender 3.4   manual, "Passes"; intern/cycles/kernel/film/data_passes.h (camera_z_depth: planar)
//   Mitsuba 3     src/integrators/aov.cpp (si.t, 0 on a miss), src/sensors/perspective.cpp (the ray starts on
//   the near
//                 plane)
//   pbrt-v4       src/pbrt/film.cpp, GBufferFilm (camera space by default; zeros on a miss)
#include "scenes/image/exr_file.h"
#include "scenes/scene/camera.h"
#include "tests/errors.h"
#include "tests/temporary_folder.h"
#include "validate/compare/imported_frame.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int kWidth = 48, kHeight = 36;

Camera sphereCamera() {
    Camera camera;
    camera.positionWorld = {0.4, 1.5, 2.6};
    camera.fovYDegrees = 50;
    camera.width = kWidth;
    camera.height = kHeight;
    return camera;
}

struct Hit {
    Vec3 position, normal;
    double distance, depth;
};

/// The hit with the unit sphere around the origin at the pixel's center: |o + t d| = 1.
std::optional<Hit> hitAt(const Camera& camera, size_t pixel) {
    const CameraRays rays(camera);
    const Ray ray = rays.ray(double(pixel % kWidth) + 0.5, double(pixel / kWidth) + 0.5);
    const double half = glm::dot(ray.origin, ray.direction);
    const double root = half * half - glm::dot(ray.origin, ray.origin) + 1;
    if (root < 0) return std::nullopt;
    const double t = -half - std::sqrt(root);
    return Hit{ray.at(t), ray.at(t), t, rays.planarDepth(ray.at(t))};
}

using Planes = std::map<std::string, std::vector<float>>;

/// The values of a channel: per pixel that of its hit, or `miss`.
std::vector<float> plane(double miss, const std::function<double(const Hit&)>& valueOf) {
    std::vector<float> values;
    for (size_t pixel = 0; pixel < kWidth * kHeight; ++pixel) {
        const auto hit = hitAt(sphereCamera(), pixel);
        values.push_back(static_cast<float>(hit ? valueOf(*hit) : miss));
    }
    return values;
}

/// Adds three channels, PREFIX.X and so on, 0 on a miss.
void addVector(Planes& planes, const std::string& prefix, const std::function<Vec3(const Hit&)>& valueOf) {
    for (int axis = 0; axis < 3; ++axis)
        planes[prefix + "." + "XYZ"[axis]] = plane(0, [&](const Hit& hit) { return valueOf(hit)[axis]; });
}

/// The rotation of Blender's OBJ and PLY importers for meshes with Y up.
Vec3 zUp(const Vec3& v) {
    return {v.x, -v.z, v.y};
}
Vec3 positionOf(const Hit& hit) {
    return hit.position;
}
Vec3 normalOf(const Hit& hit) {
    return hit.normal;
}
/// pbrt's camera space: x right, y up, z forward.
Vec3 pbrtCamera(const Vec3& position, double w) {
    const Vec4 view = viewFromWorld(sphereCamera()) * Vec4(position, w);
    return {view.x, view.y, -view.z};
}

Planes blenderPlanes() {
    Planes planes{{"ViewLayer.Depth.Z", plane(1e10, [](const Hit& hit) { return hit.depth; })},
                  {"ViewLayer.IndexOB.X", plane(0, [](const Hit&) { return 1; })},
                  {"ViewLayer.Combined.A", plane(1, [](const Hit&) { return 1; })}};
    for (const char* channel : {"R", "G", "B"})
        planes[std::string("ViewLayer.Combined.") + channel] = plane(0.5, [](const Hit&) { return 0.25; });
    addVector(planes, "ViewLayer.Normal", normalOf);
    return planes;
}

class ImportedFrames : public testing::Test {
  protected:
    ImportedFrame read(const Planes& planes, const std::vector<std::string>& map = {}) const {
        std::map<std::string, std::span<const float>> spans(planes.begin(), planes.end());
        writeExr(folder_ / "a.exr", kWidth, kHeight, spans, {});
        return readImportedFrame(folder_ / "a.exr", parseChannelMap(map));
    }
    /// Also stores the notes.
    Frame converted(const Planes& planes, const std::vector<std::string>& map = {},
                    const std::optional<Camera>& camera = sphereCamera()) {
        ImportedFrame imported = read(planes, map);
        notes_ = convertFrame(imported, camera);
        return imported.frame;
    }
    std::string errorOf(const Planes& planes, const std::vector<std::string>& map = {},
                        const std::optional<Camera>& camera = sphereCamera()) {
        return inputErrorOf([&] { converted(planes, map, camera); });
    }

    TemporaryFolder folder_;
    std::vector<std::string> notes_;
};

void expectCoverage(const Frame& frame) {
    const auto coverage = frame.channel(frame.has("id") ? "id" : "A");
    int covered = 0;
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel) {
        const bool isHit = hitAt(sphereCamera(), pixel).has_value();
        EXPECT_EQ(coverage[pixel], isHit ? 1.0f : 0.0f) << pixel;
        covered += isHit;
    }
    EXPECT_GT(covered, 100);
    EXPECT_LT(covered, kWidth * kHeight - 100);
}

/// Values below 4 were rounded to float twice.
constexpr double kTwoRoundings = 1e-6;

void expectDepth(const Frame& frame, double offBy = 0) {
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel)
        if (const auto hit = hitAt(sphereCamera(), pixel)) {
            EXPECT_NEAR(frame.channel("Z")[pixel], hit->depth + offBy, kTwoRoundings) << pixel;
        }
}

void expectVectors(const Frame& frame, const std::string& prefix) {
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel)
        if (const auto hit = hitAt(sphereCamera(), pixel)) {
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(frame.channel(prefix + "." + "XYZ"[axis])[pixel], hit->position[axis],
                            kTwoRoundings)
                    << pixel;
        }
}

TEST_F(ImportedFrames, Blender_IsImported) {
    const Frame frame = converted(blenderPlanes());
    expectCoverage(frame);
    EXPECT_TRUE(frame.has("id"));
    expectDepth(frame);
    expectVectors(frame, "N");
    EXPECT_EQ(frame.channel("R")[0], 0.5f);
    EXPECT_THAT(notes_, Contains(HasSubstr("read as a frame of Blender")));
    EXPECT_THAT(notes_, Contains(HasSubstr("Z is ViewLayer.Depth.Z")));
    EXPECT_THAT(notes_, Contains(HasSubstr("normals are assumed to be in a world with Y up")));
}

TEST_F(ImportedFrames, BlenderWithoutIndex_IsCoveredByDepth) {
    Planes planes = blenderPlanes();
    planes["ViewLayer.IndexOB.X"] = plane(0, [](const Hit&) { return 0; });
    Frame frame = converted(planes);
    EXPECT_FALSE(frame.has("id"));
    expectCoverage(frame);
    EXPECT_THAT(notes_, Contains(HasSubstr("every object has the pass index 0")));
    EXPECT_THAT(notes_, Contains(HasSubstr("covered where its depth is finite")));

    planes["ViewLayer.Depth.Z"] = plane(65504, [](const Hit& hit) { return hit.depth; }); // half
    expectCoverage(converted(planes));
    planes["ViewLayer.Depth.Z"] = plane(kInfinity, [](const Hit& hit) { return hit.depth; });
    expectCoverage(converted(planes));
}

TEST_F(ImportedFrames, BlenderWithPartialIndex_NotesLoss) {
    Planes planes = blenderPlanes();
    auto& id = planes["ViewLayer.IndexOB.X"];
    *std::find(id.begin(), id.end(), 1.0f) = 0;
    converted(planes);
    EXPECT_THAT(notes_, Contains(HasSubstr("1 pixels have a depth but no object id")));
}

// Other programs that use our channel names may write 1e10 where there is no surface.
TEST_F(ImportedFrames, OwnNamesFromOtherProgram_LoseInfiniteDepth) {
    Planes planes{{"Z", plane(1e10, [](const Hit& hit) { return hit.depth; })},
                  {"id", plane(1, [](const Hit&) { return 1; })}};
    ImportedFrame imported = read(planes);
    const auto misses = std::count(planes["Z"].begin(), planes["Z"].end(), 1e10f);
    ImportedFrame own = imported;
    const auto notes = convertFrame(imported, {});
    EXPECT_EQ(std::count(imported.frame.channel("Z").begin(), imported.frame.channel("Z").end(), kInfinityF),
              misses);
    EXPECT_THAT(notes, ElementsAre(HasSubstr(std::to_string(misses) + " covered pixels have no depth")));
    own.frame.metadata["program"] = "plumbline 0.1.0";
    EXPECT_THAT(convertFrame(own, {}), IsEmpty());
    EXPECT_EQ(own.frame.channel("Z")[0], 1e10f);
}

TEST_F(ImportedFrames, InfiniteDepthUnderId_IsNoDepth) {
    Planes planes = blenderPlanes();
    const auto& id = planes["ViewLayer.IndexOB.X"];
    const auto covered = static_cast<size_t>(std::find(id.begin(), id.end(), 1.0f) - id.begin());
    planes["ViewLayer.Depth.Z"][covered] = 1e10f;
    const Frame frame = converted(planes);
    EXPECT_EQ(frame.channel("id")[covered], 1.0f);
    EXPECT_TRUE(std::isinf(frame.channel("Z")[covered])); // counted as invalid, not as an error of 1e10
}

TEST_F(ImportedFrames, PositionSpace_IsMeasured) {
    Planes planes = blenderPlanes();
    addVector(planes, "ViewLayer.Position", [](const Hit& hit) { return zUp(hit.position); });
    addVector(planes, "ViewLayer.Normal", [](const Hit& hit) { return zUp(hit.normal); });
    Frame frame = converted(planes);
    expectVectors(frame, "P");
    expectVectors(frame, "N");
    EXPECT_THAT(notes_, Contains(HasSubstr("positions and normals are in a world with Z up")));

    addVector(planes, "ViewLayer.Position", positionOf);
    addVector(planes, "ViewLayer.Normal", normalOf);
    frame = converted(planes);
    expectVectors(frame, "P");
    expectVectors(frame, "N");
    EXPECT_THAT(notes_, Contains(HasSubstr("positions and normals are in the world, Y up")));

    addVector(planes, "ViewLayer.Position", [](const Hit& hit) { return 0.5 * hit.position; });
    EXPECT_THAT(errorOf(planes), HasSubstr("pixels; expected the reference's camera"));
}

TEST_F(ImportedFrames, MitsubaDistances_AreImported) {
    const double near = 0.01; // the default of near_clip
    const CameraRays rays(sphereCamera());
    const auto fromNearPlane = [&](const Hit& hit) { return hit.distance * (1 - near / hit.depth); };
    Planes planes{{"dd.y.T", plane(0, fromNearPlane)}};
    addVector(planes, "nn", normalOf);
    const Frame frame = converted(planes);
    expectCoverage(frame);
    expectDepth(frame);
    expectVectors(frame, "N");
    EXPECT_THAT(notes_, Contains(HasSubstr("read as a frame of Mitsuba's aov integrator")));
    EXPECT_THAT(notes_,
                Contains(HasSubstr("dd.y.T is a distance along the ray from a plane 0.01 in front of the "
                                   "camera, Mitsuba's default near_clip")));
    EXPECT_THAT(errorOf(planes, {}, std::nullopt),
                HasSubstr("dd.y.T is a distance along the ray, and the camera is not known"));
    expectDepth(converted(planes, {"dd.y.T=distance"}), -near); // measured from the pinhole, as in Mitsuba 2
    expectDepth(converted(planes, {"dd.y.T=distance+0.01"}));
}

TEST_F(ImportedFrames, MitsubaPositions_GiveDepth) {
    Planes planes{{"dd.T", plane(0, [](const Hit& hit) { return hit.distance; })}};
    addVector(planes, "position", positionOf);
    const Frame frame = converted(planes);
    EXPECT_FALSE(frame.has("Z"));
    expectCoverage(frame);
    expectVectors(frame, "P");
    EXPECT_THAT(notes_, Contains(HasSubstr("depth is computed from the positions")));
}

Planes pbrtPlanes(bool cameraSpace) {
    Planes planes{{"u", plane(0, [](const Hit& hit) { return hit.position.x; })},
                  {"v", plane(0, [](const Hit& hit) { return hit.position.y; })},
                  {"dzdx", plane(0, [](const Hit&) { return 0.1; })},
                  {"dzdy", plane(0, [](const Hit&) { return 0.1; })}};
    for (const char* channel : {"R", "G", "B", "Albedo.R", "Albedo.G", "Albedo.B", "Variance.R"})
        planes[channel] = plane(0, [](const Hit&) { return 0.25; });
    addVector(planes, "P",
              [&](const Hit& hit) { return cameraSpace ? pbrtCamera(hit.position, 1) : hit.position; });
    addVector(planes, "Ns",
              [&](const Hit& hit) { return cameraSpace ? pbrtCamera(hit.normal, 0) : hit.normal; });
    addVector(planes, "N",
              [](const Hit&) { return Vec3(0, 0, 1); }); // normals of facets, which must not be used
    return planes;
}

TEST_F(ImportedFrames, PbrtInEitherSpace_IsImported) {
    for (const bool cameraSpace : {true, false}) {
        const Frame frame = converted(pbrtPlanes(cameraSpace));
        expectCoverage(frame);
        expectVectors(frame, "P");
        expectVectors(frame, "N");
        EXPECT_EQ(frame.channel("R")[kWidth * kHeight / 2 + kWidth / 2], 0.25f);
        EXPECT_NEAR(frame.channel("st.S")[kWidth * kHeight / 2 + kWidth / 2],
                    hitAt(sphereCamera(), kWidth * kHeight / 2 + kWidth / 2)->position.x, kTwoRoundings);
        EXPECT_THAT(notes_, Contains(HasSubstr("read as a frame of pbrt's gbuffer film")));
        EXPECT_THAT(notes_,
                    Contains(HasSubstr(cameraSpace ? "in pbrt's camera space" : "in the world, Y up")));
        EXPECT_THAT(notes_, Contains(HasSubstr("covered where its position isn't (0, 0, 0)")));
    }
}

TEST_F(ImportedFrames, OwnNames_AreUnchanged) {
    Planes planes{{"Z", plane(kInfinity, [](const Hit& hit) { return hit.depth; })},
                  {"A", plane(0, [](const Hit&) { return 1; })},
                  {"shadow.T", plane(0, [](const Hit&) {
                       return 1;
                   })}}; // the shadow of a light named T, not Mitsuba's distance
    addVector(planes, "N", [](const Hit&) { return Vec3(0, 0, 1); });
    const Frame frame = converted(planes, {}, std::nullopt);
    expectCoverage(frame);
    expectDepth(frame);
    EXPECT_THAT(notes_, IsEmpty());
    planes.erase("A");
    expectCoverage(converted(planes, {}, std::nullopt));
    EXPECT_THAT(notes_, Contains(HasSubstr("has no coverage")));
}

/// A single layer of Blender: A is 1 everywhere, depth is 1e10 where there is no surface.
TEST_F(ImportedFrames, InfiniteDepth_IsNoCoverage) {
    const Planes planes{{"Z", plane(1e10, [](const Hit& hit) { return hit.depth; })},
                        {"A", plane(1, [](const Hit&) { return 1; })}};
    expectCoverage(converted(planes));
    EXPECT_THAT(notes_, Contains(HasSubstr("pixels have A = 1 and a depth of 1e10 or 65504")));
}

TEST_F(ImportedFrames, ChannelMap_RenamesAndNegates) {
    Planes planes{{"depth=m", plane(0, [](const Hit& hit) { return hit.depth; })},
                  {"mask", plane(0, [](const Hit&) { return 1; })}};
    addVector(planes, "nrm", [](const Hit& hit) { return zUp(hit.normal); });
    const Frame frame = converted(planes, {"depth=m=Z", "mask=A", "nrm.X=N.X", "nrm.Z=N.Y", "nrm.Y=-N.Z"});
    expectCoverage(frame);
    expectDepth(frame);
    expectVectors(frame, "N");
    EXPECT_THAT(notes_,
                Contains(HasSubstr("A is mask, N.X is nrm.X, N.Y is nrm.Z, N.Z is -nrm.Y, Z is depth=m")));
}

TEST_F(ImportedFrames, InvalidChannelMap_IsRefused) {
    const auto error = [](const std::string& text) {
        return inputErrorOf([&] { parseChannelMap(std::vector{text}); });
    };
    for (const char* text : {"Z", "=Z", "depth=", ""})
        EXPECT_THAT(error(text), HasSubstr("is not a pair of channels")) << text;
    EXPECT_THAT(error("depth=z"), HasSubstr("--map \"depth=z\": no channel is called 'z'"));
    for (const char* text : {"d=distances", "d=distance-1", "d=distance+", "d=distance+1x", "d=distance+inf"})
        EXPECT_THAT(error(text), HasSubstr("can't be read")) << text;
    EXPECT_THAT(inputErrorOf([] {
                    parseChannelMap(std::vector<std::string>{"a=Z", "b=distance"});
                }),
                HasSubstr("Z is mapped twice"));
    const std::string missing = errorOf(blenderPlanes(), {"ViewLayer.Dept.Z=Z"});
    EXPECT_THAT(missing, HasSubstr("has no channel 'ViewLayer.Dept.Z'"));
    EXPECT_THAT(missing, HasSubstr("did you mean 'ViewLayer.Depth.Z'?"));
}

TEST_F(ImportedFrames, TwoLayers_NeedMap) {
    Planes planes = blenderPlanes();
    planes["Other.Depth.Z"] = planes["ViewLayer.Depth.Z"];
    EXPECT_THAT(errorOf(planes), HasSubstr("both Other.Depth.Z and ViewLayer.Depth.Z could be Z"));
    expectDepth(converted(planes, {"ViewLayer.Depth.Z=Z"}));
    planes = blenderPlanes();
    planes["Composite.Combined.R"] = planes["ViewLayer.Combined.R"];
    converted(planes); // a composite isn't a layer
}

TEST_F(ImportedFrames, NoUsableChannel_IsRefused) {
    const std::string error = errorOf({{"albedo.R", plane(0, [](const Hit&) { return 1; })}});
    EXPECT_THAT(error, HasSubstr("no channel name is recognized; its channels are albedo.R"));
    EXPECT_THAT(error, HasSubstr("--map THEIRS=OURS"));
}

} // namespace
} // namespace plumbline
