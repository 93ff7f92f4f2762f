// The scene's objects on the GPU: proxy meshes, height maps and color maps. Shared by all techniques.
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

/// One object's geometry and shader inputs.
struct GpuObject {
    const SceneObject* object = nullptr;
    GlVertexArray vertexArray;
    GlBuffer vertices;
    GLsizei vertexCount = 0;
    Vec2 stOrigin{0, 0};    // whole tiles subtracted from st to preserve precision
    bool hasRelief = false; // false also for a relief too shallow for floats
    GLuint heightMap = 0, colorMap = 0;
    ReliefExtents extents;
};

/// Cost of the baked maps of a technique.
struct BakeCost {
    double ms = 0;      // of baking them, now or when they were cached
    uint64_t bytes = 0; // on the GPU
    std::vector<std::string> warnings;
};

class GpuScene {
  public:
    /// Builds the proxies and uploads all data. Throws InputError if a proxy can't be built, MachineError if
    /// the data exceeds GL's limits. A context must be current.
    GpuScene(const Scene& scene, const GlContext& context);

    /// Provides each relief's baked map of each kind, from this renderer, from the cache or by baking; draw()
    /// binds these until the next call. Throws InputError for an object whose map can't be baked,
    /// MachineError for a map that exceeds GL's limits.
    BakeCost prepareBaked(const std::vector<std::string>& kinds);
    const Bounds& boundsWorld() const { return bounds_; }
    const std::vector<GpuObject>& objects() const { return objects_; }
    /// Sets the uniforms of one object and draws its proxy with the program in use.
    void draw(size_t index, const GlProgram& program) const;
    /// Draws the objects with a relief, or those without.
    void drawObjects(bool withRelief, const GlProgram& program) const;
    /// Sets color, id and textures of one object.
    void setUniforms(size_t index, const GlProgram& program) const;
    std::vector<Vec2> stOrigins() const;
    /// Uploads the vertices relative to the view's origin.
    void upload(const Vec3& originWorld);
    /// Selects the curvature of subsequent draws; initially RingTwoTerms.
    void useCurvature(CurvatureSet set) const;

  private:
    void addObject(const SceneObject& object, const GlContext& context);
    GLuint heightMapTexture(const HeightMap& map, const GlContext& context);
    GLuint colorMapTexture(const ColorMap& map, const GlContext& context);

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
    /// Per object, what draw() binds.
    struct Binding {
        const BakedFamily* family;
        const BakedTexture* texture;
    };
    std::vector<std::vector<Binding>> bindings_;
};

} // namespace plumbline
