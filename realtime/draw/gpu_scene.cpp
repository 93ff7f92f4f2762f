#include "realtime/draw/gpu_scene.h"

#include "realtime/bake/bake_cache.h"
#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

namespace plumbline {
namespace {

// A relief shallower than this fraction of its object's diagonal is far below the single-precision resolution
// of positions (6e-8), and its rays' slopes would overflow.
constexpr double kShallowestRelief = 1e-9;
// Texture units.
constexpr GLint kHeightMapUnit = 0, kColorMapUnit = 1;

constexpr GLuint kCurvatureAttribute = 5;

/// Attributes 0 to 7 of the vertex shaders; the curvature is one of three. Triangles don't share vertices,
/// because each vertex stores the st of its triangle's corners.
struct VertexData {
    Vec3f position, normal, positionS, positionT;
    Vec2f st;
    Vec3f ringTwoTerms, ringThreeTerms, limit;
    Vec2f cornerA, cornerB, cornerC;
};

/// Into the arrays that have an element for each side.
size_t indexOf(Side side) {
    return side == Side::Front ? 0 : 1;
}

Vec3f asVector(const QuadricCoefficients& quadric) {
    return {quadric.a, quadric.b, quadric.c};
}

std::vector<VertexData> vertexData(const ProxyMesh& proxy, const Vec3& originWorld, const Vec2& stOrigin) {
    std::vector<VertexData> data;
    data.reserve(proxy.triangles.size());
    for (size_t i = 0; i < proxy.triangles.size(); ++i) {
        const auto corner = [&](size_t k) {
            return Vec2f(proxy.vertices[proxy.triangles[i / 3 * 3 + k]].st - stOrigin);
        };
        const ProxyVertex& vertex = proxy.vertices[proxy.triangles[i]];
        data.push_back({Vec3f(vertex.position - originWorld), Vec3f(vertex.normal), Vec3f(vertex.positionS),
                        Vec3f(vertex.positionT), Vec2f(vertex.st - stOrigin),
                        asVector(vertex.ringQuadric.twoTerms), asVector(vertex.ringQuadric.threeTerms),
                        asVector(vertex.limitQuadric), corner(0), corner(1), corner(2)});
    }
    return data;
}

/// Whole tiles to subtract from st; 0 for clamped maps, where st isn't periodic.
Vec2 wholeTiles(const ProxyMesh& proxy, const SceneObject& object) {
    if (!object.relief || proxy.vertices.empty()) return Vec2(0);
    Vec2 lowest(kInfinity);
    for (const ProxyVertex& vertex : proxy.vertices)
        lowest = glm::min(lowest, vertex.st);
    const HeightMap& map = *object.relief->map;
    return {map.wrapS() == Wrap::Repeat ? std::floor(lowest.x) : 0.0,
            map.wrapT() == Wrap::Repeat ? std::floor(lowest.y) : 0.0};
}

void checkTextureSize(const std::string& name, int width, int height, double bytes,
                      const GlContext& context) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width > largest || height > largest)
        throw MachineError(name, fmt::format("a map of {} x {} texels", width, height),
                           fmt::format("at most {} a side on this OpenGL", largest));
    if (context.softwareRasterizer()) requireMemory(name, bytes);
}

GLint wrapMode(Wrap wrap) {
    return wrap == Wrap::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
}

GlTexture makeMap(GLint internalFormat, GLenum format, int width, int height, const float* texels, Wrap s,
                  Wrap t) {
    GlTexture texture = GlTexture::make();
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, width, height, 0, format, GL_FLOAT, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapMode(s));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapMode(t));
    return texture;
}

void describeAttribute(GLuint location, GLint components, size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(
        location, components, GL_FLOAT, GL_FALSE, sizeof(VertexData),
        reinterpret_cast<const void*>(offset)); // NOLINT(performance-no-int-to-ptr): OpenGL's interface
}

} // namespace

GpuScene::GpuScene(const Scene& scene, const GlContext& context) {
    clearGlErrors();
    for (const SceneObject& object : scene.objects)
        addObject(scene, object, context);
}

void GpuScene::addObject(const Scene& scene, const SceneObject& object, const GlContext& context) {
    ProxyMesh proxy = buildProxyMesh(object);
    GpuObject& gpu = objects_.emplace_back();
    gpu.object = &object;
    Bounds bounds;
    for (const ProxyVertex& vertex : proxy.vertices)
        bounds.add(vertex.position);
    if (!bounds.empty()) {
        const double reach = object.relief ? object.relief->depth : 0.0;
        bounds_.add(bounds.low - Vec3(reach));
        bounds_.add(bounds.high + Vec3(reach));
    }
    gpu.hasRelief = object.relief && object.relief->depth > kShallowestRelief * bounds.diagonal();
    gpu.stOrigin = wholeTiles(proxy, object);
    gpu.extents = reliefExtents(proxy);
    gpu.backs = backSidesOf(object, proxy, scene);
    if (gpu.hasRelief) addReliefMaps(gpu, context);
    if (object.colorMap) gpu.colorMap = colorMapTexture(*object.colorMap, context);
    proxies_.push_back(std::move(proxy));
}

void GpuScene::addReliefMaps(GpuObject& gpu, const GlContext& context) {
    const HeightMap& map = *gpu.object->relief->map;
    gpu.maps[indexOf(Side::Front)] = &map;
    if (gpu.backs.toCamera || gpu.backs.toLight) {
        std::unique_ptr<const HeightMap>& complement = complements_[&map];
        if (!complement) complement = std::make_unique<const HeightMap>(complementOf(map));
        gpu.maps[indexOf(Side::Back)] = complement.get();
    }
    for (size_t side = 0; side < gpu.maps.size(); ++side)
        if (gpu.maps[side]) gpu.heightMaps[side] = heightMapTexture(*gpu.maps[side], context);
}

GLuint GpuScene::heightMapTexture(const HeightMap& map, const GlContext& context) {
    GlTexture& texture = textures_[&map];
    if (!texture) {
        checkTextureSize(map.name(), map.width(), map.height(), 4.0 * map.width() * map.height(), context);
        texture = makeMap(GL_R32F, GL_RED, map.width(), map.height(), map.depths().data(), map.wrapS(),
                          map.wrapT());
        checkGl("sending height map " + map.name());
    }
    return texture.get();
}

GLuint GpuScene::colorMapTexture(const ColorMap& map, const GlContext& context) {
    GlTexture& texture = textures_[&map];
    if (!texture) {
        checkTextureSize(map.name, map.width, map.height, 16.0 * map.width * map.height, context);
        texture =
            makeMap(GL_RGB32F, GL_RGB, map.width, map.height, map.rgb.data(), Wrap::Repeat, Wrap::Repeat);
        checkGl("sending color map " + map.name);
    }
    return texture.get();
}

const GpuScene::BakedTexture& GpuScene::bakedTexture(const HeightMap& map, const BakeRequest& request,
                                                     BakeCost& cost) {
    for (const auto& known : baked_)
        if (known->map == &map && known->request == request) return *known;
    BakeOutcome outcome = bakeCached(map, request);
    if (!outcome.warning.empty()) cost.warnings.push_back(outcome.warning);
    auto texture = std::make_unique<BakedTexture>();
    texture->map = &map;
    texture->request = request;
    texture->texture = makeBakedTexture(outcome.map);
    texture->ms = outcome.ms;
    texture->bytes = outcome.map.bytes();
    return *baked_.emplace_back(std::move(texture));
}

BakeCost GpuScene::prepareBaked(const Technique& technique) {
    BakeCost cost;
    std::set<const BakedTexture*> counted;
    bindings_.assign(objects_.size(), {});
    const auto prepare = [&](size_t index, const std::string& kind, Side side) {
        const GpuObject& gpu = objects_[index];
        BakeRequest request;
        request.kind = kind;
        if (bakeKind(kind).needsScale) request.scale = bakeScale(gpu.extents, *gpu.object, kind);
        const BakedTexture& texture = bakedTexture(*gpu.maps[indexOf(side)], request, cost);
        bindings_[index][indexOf(side)].push_back({&bakedFamily(kind), &texture});
        if (!counted.insert(&texture).second) return;
        cost.ms += texture.ms;
        cost.bytes += texture.bytes;
    };
    for (size_t i = 0; i < objects_.size(); ++i) {
        if (!objects_[i].hasRelief) continue;
        const BackSides& backs = objects_[i].backs;
        for (const std::string& kind : technique.bakedKinds()) {
            prepare(i, kind, Side::Front);
            if (backs.toCamera || (backs.toLight && technique.readsShadowMaps()))
                prepare(i, kind, Side::Back);
        }
    }
    return cost;
}

void GpuScene::upload(const Vec3& originWorld) {
    clearGlErrors();
    for (size_t i = 0; i < objects_.size(); ++i) {
        GpuObject& gpu = objects_[i];
        const ProxyMesh& proxy = proxies_[i];
        const std::vector<VertexData> data = vertexData(proxy, originWorld, gpu.stOrigin);
        gpu.vertexArray = GlVertexArray::make();
        gpu.vertices = GlBuffer::make();
        glBindVertexArray(gpu.vertexArray.get());
        glBindBuffer(GL_ARRAY_BUFFER, gpu.vertices.get());
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(VertexData)), data.data(),
                     GL_STATIC_DRAW);
        describeAttribute(0, 3, offsetof(VertexData, position));
        describeAttribute(1, 3, offsetof(VertexData, normal));
        describeAttribute(2, 3, offsetof(VertexData, positionS));
        describeAttribute(3, 3, offsetof(VertexData, positionT));
        describeAttribute(4, 2, offsetof(VertexData, st));
        describeAttribute(6, 4, offsetof(VertexData, cornerA)); // A and B
        describeAttribute(7, 2, offsetof(VertexData, cornerC));
        gpu.vertexCount = static_cast<GLsizei>(data.size());
        checkGl("sending the proxy mesh of " + gpu.object->name);
    }
    glBindVertexArray(0);
    proxies_.clear();
    useCurvature(CurvatureSet::RingTwoTerms);
}

void GpuScene::useCurvature(CurvatureSet set) const {
    for (const GpuObject& gpu : objects_) {
        glBindVertexArray(gpu.vertexArray.get());
        glBindBuffer(GL_ARRAY_BUFFER, gpu.vertices.get());
        switch (set) { // a missing third component reads as 0
        case CurvatureSet::RingTwoTerms:
            describeAttribute(kCurvatureAttribute, 2, offsetof(VertexData, ringTwoTerms));
            break;
        case CurvatureSet::RingThreeTerms:
            describeAttribute(kCurvatureAttribute, 3, offsetof(VertexData, ringThreeTerms));
            break;
        case CurvatureSet::LimitTwoTerms:
            describeAttribute(kCurvatureAttribute, 2, offsetof(VertexData, limit));
            break;
        case CurvatureSet::LimitThreeTerms:
            describeAttribute(kCurvatureAttribute, 3, offsetof(VertexData, limit));
            break;
        }
    }
    glBindVertexArray(0);
}

void GpuScene::setUniforms(size_t index, const GlProgram& program, Side side) const {
    const GpuObject& gpu = objects_[index];
    const Vec3f color(gpu.object->color);
    glUniform3f(program.uniform("uColor"), color.x, color.y, color.z);
    glUniform1f(program.uniform("uObjectId"), static_cast<float>(index + 1));
    glUniform1i(program.uniform("uHasColorMap"), gpu.colorMap != 0);
    glUniform1i(program.uniform("uColorMap"), kColorMapUnit);
    glActiveTexture(GL_TEXTURE0 + kColorMapUnit);
    glBindTexture(GL_TEXTURE_2D, gpu.colorMap);
    glActiveTexture(GL_TEXTURE0 + kHeightMapUnit);
    glBindTexture(GL_TEXTURE_2D, gpu.heightMaps[indexOf(side)]);
    if (!gpu.hasRelief) return;
    const Relief& relief = *gpu.object->relief;
    glUniform1i(program.uniform("uHeightMap"), kHeightMapUnit);
    glUniform2i(program.uniform("uHeightMapClamps"), relief.map->wrapS() == Wrap::Clamp,
                relief.map->wrapT() == Wrap::Clamp);
    glUniform1f(program.uniform("uReliefDepthWorld"), static_cast<float>(relief.depth));
    if (bindings_.empty()) return;
    for (const auto& [family, baked] : bindings_[index][indexOf(side)]) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(family->unit));
        glBindTexture(GL_TEXTURE_2D_ARRAY, baked->texture.get());
        glUniform1i(program.uniform(family->sampler), family->unit);
        const BakeScale& scale = baked->request.scale;
        if (family->scaleUniform)
            glUniform3f(program.uniform(family->scaleUniform), static_cast<float>(scale.s),
                        static_cast<float>(scale.t), static_cast<float>(scale.depth));
    }
}

void GpuScene::draw(size_t index, const GlProgram& program, Side side) const {
    setUniforms(index, program, side);
    glBindVertexArray(objects_[index].vertexArray.get());
    glDrawArrays(GL_TRIANGLES, 0, objects_[index].vertexCount);
}

void GpuScene::drawPlain(const GlProgram& program) const {
    for (size_t i = 0; i < objects_.size(); ++i) {
        if (objects_[i].hasRelief) continue;
        (objects_[i].backs.toCamera ? glDisable : glEnable)(GL_CULL_FACE);
        draw(i, program);
    }
}

void GpuScene::drawPlainFromLight(const GlProgram& program) const {
    glDisable(GL_CULL_FACE); // both sides cast shadows, as in the reference
    for (size_t i = 0; i < objects_.size(); ++i)
        if (!objects_[i].hasRelief) draw(i, program);
}

void GpuScene::drawReliefs(const GlProgram& program, Side side, bool BackSides::*viewer) const {
    glEnable(GL_CULL_FACE);
    glCullFace(side == Side::Front ? GL_BACK : GL_FRONT);
    for (size_t i = 0; i < objects_.size(); ++i)
        if (objects_[i].hasRelief && (side == Side::Front || objects_[i].backs.*viewer))
            draw(i, program, side);
    glCullFace(GL_BACK);
}

bool GpuScene::hasReliefBacks(bool BackSides::*viewer) const {
    return std::any_of(objects_.begin(), objects_.end(),
                       [&](const GpuObject& gpu) { return gpu.hasRelief && gpu.backs.*viewer; });
}

std::vector<Vec2> GpuScene::stOrigins() const {
    std::vector<Vec2> origins;
    for (const GpuObject& gpu : objects_)
        origins.push_back(gpu.stOrigin);
    return origins;
}

} // namespace plumbline
