// The scene's objects on the GPU: proxy meshes, height maps and color maps. Shared by all techniques.
#pragma once

#include "realtime/draw/back_sides.h"
#include "realtime/draw/baked_input.h"
#include "realtime/gl/gl_context.h"
#include "realtime/gl/gl_objects.h"
#include "realtime/gl/gl_program.h"
#include "realtime/technique/baked_family.h"
#include "realtime/technique/stage_sources.h"
#include "realtime/technique/technique.h"
#include "scenes/scene/scene.h"
#include "scenes/surface/proxy_mesh.h"

#include <array>
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
    /// A relief's map for each Side; the back's is its complement, null if no back side is drawn.
    std::array<const HeightMap*, 2> maps{};
    std::array<GLuint, 2> heightMaps{};
    GLuint colorMap = 0;
    BackSides backs;
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

    /// Provides each relief's baked map of each kind, from this renderer, from the cache or by baking, and
    /// those of its complement where back sides are drawn; draw() binds these until the next call. Throws
    /// InputError for an object whose map can't be baked, MachineError for a map that exceeds GL's limits.
    BakeCost prepareBaked(const Technique& technique);
    const Bounds& boundsWorld() const { return bounds_; }
    const std::vector<GpuObject>& objects() const { return objects_; }
    /// Sets the uniforms of one object and draws its proxy with the program in use.
    void draw(size_t index, const GlProgram& program, Side side = Side::Front) const;
    /// Draws the objects without a relief, with the sides that the camera sees.
    void drawPlain(const GlProgram& program) const;
    /// The same with both sides, from a light.
    void drawPlainFromLight(const GlProgram& program) const;
    /// Draws one side of the objects with a relief: `program` is one for that side.
    void drawReliefs(const GlProgram& program, Side side, bool BackSides::*viewer) const;
    /// Whether a relief has back sides to draw.
    bool hasReliefBacks(bool BackSides::*viewer) const;
    /// Sets color, id and textures of one object.
    void setUniforms(size_t index, const GlProgram& program, Side side = Side::Front) const;
    std::vector<Vec2> stOrigins() const;
    /// Uploads the vertices relative to the view's origin.
    void upload(const Vec3& originWorld);
    /// Selects the curvature of subsequent draws; initially RingTwoTerms.
    void useCurvature(CurvatureSet set) const;

  private:
    void addObject(const Scene& scene, const SceneObject& object, const GlContext& context);
    void addReliefMaps(GpuObject& gpu, const GlContext& context);
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
    std::vector<std::array<std::vector<Binding>, 2>> bindings_; // for each Side
    std::map<const HeightMap*, std::unique_ptr<const HeightMap>> complements_;
};

} // namespace plumbline
