#include "scenes/scene_file/scene_shape.h"

#include "scenes/core/error.h"
#include "scenes/mesh/shapes/shapes.h"

#include <algorithm>
#include <functional>

namespace plumbline {
namespace {

constexpr double kLargestSize = 1e9; // world units
constexpr double kSmallestSize = 1e-9;
constexpr int kMaxSegments = 65536; // shapes.h has tighter limits for each kind

/// Creates the mesh after all fields have been read and checked.
using Maker = std::function<ControlMesh()>;

double size(const TomlTable& shape, const char* key, double fallback) {
    return shape.number(key, kSmallestSize, kLargestSize, fallback);
}

Vec2i segments2(const TomlTable& shape, Vec2i fallback) {
    return shape.integers2("segments", 1, kMaxSegments, fallback);
}

int segments1(const TomlTable& shape, int fallback) {
    return shape.integer("segments", 1, kMaxSegments, fallback);
}

Maker plane(const TomlTable& shape) {
    const double width = size(shape, "width", 2), depth = size(shape, "depth", 2);
    const Vec2i segments = segments2(shape, {1, 1});
    return [=] { return makePlane(width, depth, segments.x, segments.y); };
}

Maker quadric(const TomlTable& shape) {
    constexpr double kLargestCurvature = 1e6;
    const double a = shape.number("a", -kLargestCurvature, kLargestCurvature);
    const double b = shape.number("b", -kLargestCurvature, kLargestCurvature);
    const double halfSize = size(shape, "half_size", 1);
    const int segments = segments1(shape, 4);
    return [=] { return makeQuadric(a, b, halfSize, segments); };
}

Maker sphere(const TomlTable& shape) {
    const double radius = size(shape, "radius", 1);
    const int segments = segments1(shape, 4);
    return [=] { return makeSphere(radius, segments); };
}

Maker cylinder(const TomlTable& shape) {
    const double radius = size(shape, "radius", 1), height = size(shape, "height", 2);
    const Vec2i segments = segments2(shape, {16, 4});
    return [=] { return makeCylinder(radius, height, segments.x, segments.y); };
}

Maker torus(const TomlTable& shape) {
    const double major = size(shape, "major", 1), minor = size(shape, "minor", 0.4);
    const Vec2i segments = segments2(shape, {16, 8});
    return [=] { return makeTorus(major, minor, segments.x, segments.y); };
}

Maker box(const TomlTable& shape) {
    const Vec3 edges = shape.vector3("size", kSmallestSize, kLargestSize, Vec3(1));
    const int segments = segments1(shape, 1);
    return [=] { return makeBox(edges, segments); };
}

Maker teapot(const TomlTable& shape) {
    const int segments = segments1(shape, 4);
    return [=] { return makeTeapot(segments); };
}

struct Kind {
    std::string name;
    Maker (*read)(const TomlTable& shape);
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"plane", plane}, {"quadric", quadric}, {"sphere", sphere}, {"cylinder", cylinder},
        {"torus", torus}, {"box", box},         {"teapot", teapot},
    };
    return all;
}

} // namespace

ControlMesh readShape(const TomlTable& shape) {
    std::vector<std::string> names;
    for (const Kind& kind : kinds())
        names.push_back(kind.name);
    const std::string name = shape.choice("kind", names);
    const auto kind = std::ranges::find(kinds(), name, &Kind::name);
    const Maker make = kind->read(shape);
    shape.finish();
    try {
        return make();
    } catch (const InputError& error) { // add the line, which shapes.h doesn't know
        shape.fail({}, error.what());
    }
}

} // namespace plumbline
