// Reliefs displaced along an axis of their object: compared with closed forms and, where both agree, with
// reliefs along the normal; and the tests of facing.
#include "reference/rates/face_role.h"
#include "reference/reference.h"
#include "reference/tessellate/tessellate.h"
#include "reference/trace/facing.h"
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/displaced_surface.h"
#include "tests/reference/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>

namespace plumbline {
namespace {

Relief noiseRelief(double depth) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<float> depths(16 * 16);
    for (float& d : depths)
        d = uniform(random);
    return {std::make_shared<HeightMap>("noise", 16, 16, depths), depth, 0.02, {1, 1}, {0.3, 0.1}};
}

/// z = a x^2 + b y^2 over [-1, 1]^2, rotated, scaled and translated, with a relief along its axis.
SceneObject quadric(double a, double b, double depth) {
    SceneObject object;
    object.name = "quadric";
    object.mesh = makeQuadric(a, b, 1, 2);
    object.rotateDegrees = {-70, 25, 10};
    object.scale = 1.5;
    object.translate = {0.3, -0.2, 0.1};
    object.relief = noiseRelief(depth);
    object.relief->axisWorld = object.axisWorld();
    return object;
}

Scene sceneOf(SceneObject object) {
    Scene scene;
    scene.camera.projection = Camera::Projection::Orthographic;
    scene.camera.positionWorld = {1, 5, 2};
    scene.camera.viewHeight = 4;
    scene.camera.width = scene.camera.height = 96;
    Light light;
    light.name = "sun";
    light.toLightWorld = glm::normalize(Vec3(1, 1, 0.3));
    scene.lights.push_back(light);
    scene.objects.push_back(std::move(object));
    return scene;
}

Frame render(const Scene& scene) {
    ReferenceOptions options;
    options.rate = 64;
    return ReferenceScene(scene, options).render();
}

// The object's +z is the third column of the rotation: rotated about x by 90 degrees it is -y, then about z
// by 90 degrees +x.
TEST(AlongAxis, Transform_RotatesAxisWithoutScale) {
    SceneObject object;
    EXPECT_EQ(object.axisWorld(), Vec3(0, 0, 1));
    object.rotateDegrees = {90, 0, 90};
    object.scale = 3;
    EXPECT_LT(glm::length(object.axisWorld() - Vec3(1, 0, 0)), 1e-15);
}

// In the object's space the base is s (x, y, a x^2 + b y^2), (x, y) = 2 uv - 1, and the relief only displaces
// z, in world units: P_x = s (1, 0, 2 a x) - depth d_x z, P_y likewise. The shape and the refinement are
// exact, so only float rounding remains, 2^-24 of coordinates up to 2.5. Normals, from st in float, 2^-24
// off: the map's gradient changes by up to 2 * 16^2 of that, 3e-5, and the slope by depth / 2 / s of it: 6e-6
// at depth 0.6.
TEST(AlongAxis, Quadric_HasClosedForm) {
    for (const double depth : {0.1, 0.6}) {
        const double a = 0.6, b = -0.4;
        const SceneObject object = quadric(a, b, depth);
        const Relief& relief = *object.relief;
        const Mat4 toWorld = worldFromObject(object);
        const Frame frame = render(sceneOf(object));
        double worstPosition = 0, worstNormal = 0;
        int covered = 0;
        for (size_t i = 0; i < frame.pixelCount(); ++i) {
            const auto at = [&](const char* name) { return double(frame.channel(name)[i]); };
            if (at("A") == 0) continue;
            const Vec2 st(at("st.S"), at("st.T")), xy = 2.0 * (st - relief.uvOffset) - 1.0;
            const HeightMap::Sample map = relief.map->sample(st);
            const Vec2 slope =
                2.0 * Vec2(a * xy.x, b * xy.y) - depth / object.scale * map.gradient * 0.5; // dz/dx, dz/dy
            const double z =
                a * xy.x * xy.x + b * xy.y * xy.y + (relief.offset - depth * map.depth) / object.scale;
            const Vec3 position(toWorld * Vec4(xy, z, 1));
            const Vec3 normal = glm::normalize(Vec3(toWorld * Vec4(-slope.x, -slope.y, 1, 0)));
            worstPosition =
                std::max(worstPosition, glm::length(position - Vec3(at("P.X"), at("P.Y"), at("P.Z"))));
            // At a crease of the map, the float st may be on the other side.
            const Vec2 texel = st * 16.0 - 0.5;
            const Vec2 fromCrease = glm::abs(texel - glm::round(texel));
            if (std::min(fromCrease.x, fromCrease.y) > 1e-4)
                worstNormal =
                    std::max(worstNormal, glm::length(normal - Vec3(at("N.X"), at("N.Y"), at("N.Z"))));
            ++covered;
        }
        std::printf("depth %g: %d pixels, off by %.1e, normals by %.1e\n", depth, covered, worstPosition,
                    worstNormal);
        EXPECT_GT(covered, 2000);
        EXPECT_LT(worstPosition, 2e-6);
        EXPECT_LT(worstNormal, 1e-5);
    }
}

// At constant depth the whole surface is translated, so the micro-triangles are those of the base,
// translated. 1e-6 is for float rounding.
TEST(AlongAxis, ConstantDepth_TranslatesSurface) {
    SceneObject object = quadric(-0.8, 0.3, 0.5);
    object.relief->map = std::make_shared<HeightMap>(HeightMap::constant("flat", 0.25f));
    const std::unique_ptr<BaseSurface> surface = makeBaseSurface(object);
    const Rates rates = uniformRates(*surface, 16);
    const MicroMesh base = tessellate(*surface, nullptr, rates, false);
    const MicroMesh moved = tessellate(*surface, &*object.relief, rates, false);
    const Vec3 by = object.axisWorld() * (0.02 - 0.5 * 0.25);
    for (size_t i = 0; i < base.positionsWorld.size(); ++i)
        EXPECT_LT(glm::length(Vec3(moved.positionsWorld[i]) - Vec3(base.positionsWorld[i]) - by), 1e-6);
    for (size_t i = 0; i < base.grids.size(); ++i)
        EXPECT_NEAR(moved.grids[i].errorWorld, base.grids[i].errorWorld, 1e-6);
}

// If the base is flat and its normal is the object's z, both surfaces are equal. Without a rotation, all
// channels are bit-identical.
TEST(AlongAxis, Plane_AxisIsNormal) {
    SceneObject plane = quadric(0, 0, 0.2);
    plane.rotateDegrees = Vec3(0);
    for (const Seams seams : {Seams::Weld, Seams::Open}) {
        plane.relief->seams = seams;
        plane.relief->axisWorld.reset();
        Scene scene = sceneOf(plane);
        const Frame normal = render(scene);
        scene.objects[0].relief->axisWorld = plane.axisWorld();
        const Frame axis = render(scene);
        ASSERT_EQ(normal.channelNames(), axis.channelNames());
        for (const std::string& name : normal.channelNames()) {
            const auto one = normal.channel(name), other = axis.channel(name);
            EXPECT_EQ(std::memcmp(one.data(), other.data(), one.size_bytes()), 0) << name;
        }
    }
}

// Rotations aren't exact: the normal, computed from tangents, and the axis agree up to rounding, and frames
// up to float rounding.
TEST(AlongAxis, RotatedPlane_AxisIsNormalToRounding) {
    SceneObject plane = quadric(0, 0, 0.2);
    const std::unique_ptr<BaseSurface> surface = makeBaseSurface(plane);
    BaseSurface::Evaluator evaluator(*surface);
    Relief along = *plane.relief;
    along.axisWorld.reset();
    for (int patch = 0; patch < static_cast<int>(surface->patches().size()); ++patch)
        for (const Vec2 uv : {Vec2(0, 0), Vec2(0.3, 0.7), Vec2(1, 0.25)}) {
            evaluator.setPatch(patch);
            const BaseSample base = evaluator.sample(uv.x, uv.y);
            const DisplacedSample axis = displace(base, &*plane.relief), normal = displace(base, &along);
            EXPECT_LT(glm::length(axis.position - normal.position), 1e-14);
            EXPECT_LT(glm::length(axis.positionU - normal.positionU), 1e-14);
            EXPECT_LT(glm::length(axis.normal - normal.normal), 1e-14);
        }
}

// Displaced along normals, the far side of a sphere is never visible; along an axis, its relief may face the
// camera.
TEST(AlongAxis, BackFaces_CountAsSeen) {
    SceneObject sphere;
    sphere.name = "sphere";
    sphere.mesh = makeSphere(1, 4);
    sphere.relief = noiseRelief(0.1);
    const Scene scene = sceneOf(sphere);
    const std::unique_ptr<BaseSurface> surface = makeBaseSurface(sphere);
    const auto seen = [&](const Relief& relief) {
        int count = 0;
        for (const FacePlace& place : placeFaces(scene, *surface, &relief))
            count += place.role == FaceRole::Seen;
        return count;
    };
    EXPECT_LT(seen(*sphere.relief), 80);
    sphere.relief->axisWorld = Vec3(0, 0, 1);
    EXPECT_EQ(seen(*sphere.relief), 96);
}

/// Checks facesThroughout: within the radius no point of P faces the other way.
void expectPromisesKept(const SceneObject& object, int leastPromises, int leastTurning) {
    const Relief& relief = *object.relief;
    const std::unique_ptr<BaseSurface> surface = makeBaseSurface(object);
    BaseSurface::Evaluator evaluator(*surface);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto offCenter = [&] { return unit(random) - 0.5; };
    int promises = 0, turning = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        evaluator.setPatch(static_cast<int>(random() % 4));
        const Vec2 uv(unit(random), unit(random));
        const BaseSample base = evaluator.sample(uv.x, uv.y);
        const Vec3 place = displace(base, &relief).position;
        const Vec3 toward =
            glm::normalize(*relief.axisWorld + 2.5 * Vec3(offCenter(), offCenter(), offCenter()));
        const double radius = 0.03 * unit(random);
        const bool promised = facesThroughout(base, &relief, radius, toward, 1);
        int away = 0;
        for (int look = 0; look < 50; ++look) {
            const Vec2 other = glm::clamp(uv + 0.1 * Vec2(offCenter(), offCenter()), Vec2(0), Vec2(1));
            const DisplacedSample sample = displace(evaluator.sample(other.x, other.y), &relief);
            away += glm::length(sample.position - place) < radius && glm::dot(sample.normal, toward) < 0;
        }
        promises += promised;
        turning += away > 0;
        EXPECT_TRUE(!promised || away == 0) << "trial " << trial;
    }
    std::printf("%d promises, %d turn away\n", promises, turning);
    EXPECT_GT(promises, leastPromises);
    EXPECT_GT(turning, leastTurning);
}

// A flat base inclined by 75 degrees to the plane orthogonal to the axis: a radius on P covers four times as
// many texels as along the base.
TEST(AlongAxis, FacingEverywhere_IsFacing) {
    expectPromisesKept(quadric(0.1, 1.4, 0.25), 1000, 400);
    SceneObject leaning = quadric(0, 0, 0.25);
    leaning.rotateDegrees = {75, 0, 0};
    leaning.relief->axisWorld = Vec3(0, 0, 1);
    expectPromisesKept(leaning, 500, 500);
}

} // namespace
} // namespace plumbline
