#include "realtime/draw/baked_input.h"

#include "realtime/technique/baked_family.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {

ReliefExtents reliefExtents(const ProxyMesh& proxy) {
    Vec2 least(kInfinity), sum(0);
    double largestCosine = 0, count = 0;
    for (const ProxyVertex& vertex : proxy.vertices) {
        const Vec2 scale(glm::length(vertex.positionS), glm::length(vertex.positionT));
        least = glm::min(least, scale);
        if (!(scale.x > 0 && scale.y > 0)) continue;
        sum += scale;
        ++count;
        const double cosine = std::abs(glm::dot(vertex.positionS, vertex.positionT)) / (scale.x * scale.y);
        largestCosine = std::max(largestCosine, std::min(cosine, 1.0));
    }
    if (count == 0) return {};
    // |a S + b T|^2 >= (1 - |cos|) (a^2 |S|^2 + b^2 |T|^2).
    return {sum / count, least * std::sqrt(1.0 - largestCosine)};
}

BakeScale bakeScale(const ReliefExtents& extents, const SceneObject& object, const std::string& kind) {
    const double depth = object.relief->depth;
    if (!(extents.mean.x > 0))
        throw InputError(object.name, "its texture coordinates have no extent anywhere",
                         "uvs that span an area");
    if (kind == "normal") return {extents.mean.x, extents.mean.y, depth};
    if (!(extents.least.x > 0 && extents.least.y > 0))
        throw InputError(
            object.name,
            fmt::format("its texture coordinates have no extent somewhere (a pole), so '{}' has no metric",
                        kind),
            "uvs that span an area everywhere");
    return {extents.least.x, extents.least.y, depth};
}

BakedMap::Level packLevels(const BakedMap& map) {
    const BakedMap::Level& first = map.levels.front();
    const auto rowOf = [&](size_t k) {
        return first.height - (first.height >> (k - 1)) + static_cast<int>(k) - 1;
    };
    BakedMap::Level packed{first.width, first.height, {}};
    if (map.levels.size() > 1) {
        packed.width += map.levels[1].width;
        packed.height = std::max(packed.height, rowOf(map.levels.size() - 1) + map.levels.back().height);
    }
    const auto channels = static_cast<size_t>(map.channels), width = static_cast<size_t>(packed.width);
    packed.values.assign(width * static_cast<size_t>(packed.height) * channels, 0.0f);
    for (size_t k = 0; k < map.levels.size(); ++k) {
        const BakedMap::Level& level = map.levels[k];
        const auto column = static_cast<size_t>(k == 0 ? 0 : first.width),
                   row = static_cast<size_t>(k == 0 ? 0 : rowOf(k));
        const size_t rowValues = static_cast<size_t>(level.width) * channels;
        for (size_t j = 0; j < static_cast<size_t>(level.height); ++j)
            std::copy_n(&level.values[j * rowValues], rowValues,
                        &packed.values[((row + j) * width + column) * channels]);
    }
    return packed;
}

GlTexture makeBakedTexture(const BakedMap& map) {
    static constexpr std::array<GLint, 5> kInternal{0, GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
    static constexpr std::array<GLenum, 5> kFormat{0, GL_RED, GL_RG, GL_RGB, GL_RGBA};
    const bool packs = bakedFamily(map.kind).packsLevels;
    const BakedMap::Level packed = packs ? packLevels(map) : BakedMap::Level{};
    const BakedMap::Level& sent = packs ? packed : map.levels.front();
    GLint largest = 0, mostLayers = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &mostLayers);
    if (sent.width > largest || sent.height > largest || map.slices > mostLayers)
        throw MachineError(
            map.kind,
            fmt::format("a map of {} x {} texels and {} slices", sent.width, sent.height, map.slices),
            fmt::format("at most {} a side and {} slices on this OpenGL", largest, mostLayers));
    clearGlErrors();
    GlTexture texture = GlTexture::make();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const auto channels = static_cast<size_t>(map.channels);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, kInternal[channels], sent.width, sent.height, map.slices, 0,
                 kFormat[channels], GL_FLOAT, sent.values.data());
    // Shaders fetch texels, so the sampler's filtering and wrapping are irrelevant.
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    checkGl(fmt::format("sending the baked map {}", map.kind));
    return texture;
}

} // namespace plumbline
