#include "scenes/mesh/shapes/shape_parts.h"

#include "scenes/core/error.h"
#include "scenes/mesh/shapes/shapes.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline {

std::string whereOfShape(std::string_view shape) {
    return fmt::format("shape '{}'", shape);
}

void requirePositive(std::string_view shape, std::string_view parameter, double value) {
    if (!(value > 0) || !std::isfinite(value))
        throw InputError(whereOfShape(shape), fmt::format("{} = {}", parameter, value),
                         "a positive, finite number");
}

void requireFinite(std::string_view shape, std::string_view parameter, double value) {
    if (!std::isfinite(value))
        throw InputError(whereOfShape(shape), fmt::format("{} = {}", parameter, value), "a finite number");
}

void requireSegments(std::string_view shape, std::string_view parameter, int value, int fewest, int most) {
    if (value < fewest || value > most)
        throw InputError(whereOfShape(shape), fmt::format("{} = {}", parameter, value),
                         fmt::format("a whole number from {} to {}", fewest, most));
}

void requireFaces(std::string_view shape, int64_t faces) {
    if (faces > kMaxShapeFaces)
        throw InputError(whereOfShape(shape), fmt::format("{} faces", faces),
                         fmt::format("at most {}", kMaxShapeFaces),
                         "a control mesh is coarse; the reference subdivides it as far as the relief needs");
}

int appendUvLattice(ControlMesh& mesh, int columns, int rows, const Vec2& low, const Vec2& high) {
    const int first = countOf(mesh.uvs);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            mesh.uvs.push_back(low + (high - low) * Vec2(double(i) / columns, double(j) / rows));
    return first;
}

} // namespace plumbline
