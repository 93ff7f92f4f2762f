// The scene's objects on the GPU: proxy meshes, height maps, color maps. Shared by all techniques.
#pragma once

#include "realtime/draw/baked_input.h"
#include "realtime/gl/gl_context.h"
#include "realtime/gl/gl_objects.h"
#include "realtime/gl/gl_program.h"
#include "realtime/technique/baked_family.h"
#include "realtime/technique/technique.h"
#include "scenes/scene/scene.h"
#include "scenes/surface/proxy_mesh.h"

#include <map>
#include <memory>
#include <vector>

namespace plumbline {

/// One object's geometry and what its shader needs to know.
struct GpuObject {
    const SceneObject* object = nullptr;
    GlVertexArray vertexArray;
    GlBuffer vertices;
    GLsizei vertexCount = 0;
    Vec2 stOrigin{0, 0};    // whole tiles taken off st, so that float keeps its digits
    bool hasRelief = false; // a relief too shallow for float counts as none
    GLuint heightMap = 0, colorMap = 0;
    ReliefExtents extents;
};

/// What the baked maps of a technique cost.
struct BakeCost {
    double ms = 0;      // of making them, now or when they came into the cache
    uint64_t bytes = 0; // on the GPU
    std::vector<std::string> warnings;
};

class GpuScene {
  public:
    /// Builds the proxies and sends everything. Throws InputError for a scene that has none, MachineError if
    /// it doesn't fit. A context must be current.
    GpuScene(const Scene& scene, const GlContext& context);

    /// Gives every relief its map of each kind, from this renderer, the cache or by baking; draw() binds
    /// these until the next call. Throws InputError for an object that can't have one, MachineError for one
    /// that doesn't fit.
    BakeCost prepareBaked(const std::vector<std::string>& kinds);
    const Bounds& boundsWorld() const { return bounds_; }
    const std::vector<GpuObject>& objects() const { return objects_; }
    /// Sets the uniforms of one object and draws its proxy with the program in use.
    void draw(size_t index, const GlProgram& program) const;
    /// Those with a relief, or those without.
    void drawObjects(bool withRelief, const GlProgram& program) const;
    /// Sets color, id and textures of one object.
    void setUniforms(size_t index, const GlProgram& program) const;
    std::vector<Vec2> stOrigins() const;
    /// Sends the vertices, relative to the origin a view chose.
    void upload(const Vec3& originWorld);
    /// For the draws to come; RingTwoTerms until then.
    void useCurvature(CurvatureSet set) const;

  private:
    void addObject(const SceneObject& object, const GlContext& context);
    GLuint heightMapTexture(const HeightMap& map, const GlContext& context);
    GLuint colorMapTexture(const ColorMap& map, const GlContext& context);

    const Scene& scene_;
    Bounds bounds_;
    std::vector<ProxyMesh> proxies_; // until upload()
    std::vector<GpuObject> objects_;
    std::map<const void*, GlTexture> textures_; // by map

    struct BakedTexture {
        const HeightMap* map;
        BakeRequest request;
        GlTexture texture;
        double ms;
        uint64_t bytes;
    };
    const BakedTexture& bakedTexture(const HeightMap& map, const BakeRequest& request, BakeCost& cost);
    std::vector<std::unique_ptr<BakedTexture>> baked_;
    /// By object: what draw() binds.
    struct Binding {
        const BakedFamily* family;
        const BakedTexture* texture;
    };
    std::vector<std::vector<Binding>> bindings_;
};

} // namespace plumbline
