#include "realtime/draw/frame_target.h"

#include "realtime/draw/target_bytes.h"
#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline {
namespace {

/// The draw buffers, as shaders/shading.glsl writes them. Every driver supports at least 8.
enum Target { kColor, kPosition, kNormal, kTexture, kSurface, kTargets };
static_assert(kTargets == kColorTargets);
constexpr GLfloat kFarthest = 1;

void checkSize(int width, int height) {
    GLint texture = 0, viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    const int widest = std::min(texture, viewport[0]), tallest = std::min(texture, viewport[1]);
    if (width > widest || height > tallest)
        throw MachineError("camera", fmt::format("a picture of {} x {} pixels", width, height),
                           fmt::format("at most {} x {} on this OpenGL", widest, tallest));
}

GlTexture makeTarget(GLenum format, int width, int height) {
    GlTexture texture = GlTexture::make();
    glBindTexture(GL_TEXTURE_2D, texture.get());
    const bool color = format == GL_RGBA32F;
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0,
                 color ? GL_RGBA : GL_DEPTH_STENCIL, color ? GL_FLOAT : GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
                 nullptr);
    // The texture has no mip levels; without this setting it is incomplete on some drivers.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

/// Splits the targets into the channels of a frame.
class ChannelSplitter {
  public:
    /// `channels`: rows of the channel table to keep, all if empty. `texture`: the target that determines
    /// coverage.
    ChannelSplitter(int width, int height, const std::vector<std::string>& channels,
                    const std::vector<float>& texture)
        : frame_(width, height), channels_(channels), unwanted_(frame_.pixelCount()),
          covered_(frame_.pixelCount()), heightFetches_(frame_.pixelCount()) {
        forEachPixel(texture, [&](size_t i, const float* p) { covered_[i] = p[2] > 0 ? 1.0f : 0.0f; });
    }

    void addColor(const std::vector<float>& target) {
        const auto r = plane("R"), g = plane("G"), b = plane("B"), a = plane("A"),
                   iterations = plane("cost.iterations");
        forEachPixel(target, [&](size_t i, const float* p) {
            r[i] = p[0], g[i] = p[1], b[i] = p[2], a[i] = covered_[i], iterations[i] = p[3];
        });
    }

    void addPosition(const std::vector<float>& target, const Vec3& originWorld) {
        const auto x = plane("P.X"), y = plane("P.Y"), z = plane("P.Z"), depth = plane("Z");
        forEachHit(target, [&](size_t i, const float* p) {
            x[i] = static_cast<float>(p[0] + originWorld.x);
            y[i] = static_cast<float>(p[1] + originWorld.y);
            z[i] = static_cast<float>(p[2] + originWorld.z);
            depth[i] = p[3];
        });
    }

    void addNormal(const std::vector<float>& target) {
        const auto x = plane("N.X"), y = plane("N.Y"), z = plane("N.Z"),
                   heights = plane("cost.fetches.height");
        forEachHit(target, [&](size_t i, const float* p) {
            x[i] = p[0], y[i] = p[1], z[i] = p[2], heights[i] = p[3];
            heightFetches_[i] = p[3];
        });
    }

    /// Must be called after addNormal, which reads the number of height-map lookups.
    void addTexture(const std::vector<float>& target, const std::vector<Vec2>& stOrigins) {
        const auto s = plane("st.S"), t = plane("st.T"), id = plane("id"),
                   baked = plane("cost.fetches.baked"), all = plane("cost.fetches");
        forEachHit(target, [&](size_t i, const float* p) {
            const Vec2 origin = stOrigins[static_cast<size_t>(p[2]) - 1];
            s[i] = static_cast<float>(p[0] + origin.x);
            t[i] = static_cast<float>(p[1] + origin.y);
            id[i] = p[2];
            baked[i] = p[3];
            all[i] = heightFetches_[i] + p[3];
        });
    }

    void addCurvature(const std::vector<float>& target) {
        const auto a = plane("curvature.a"), b = plane("curvature.b"), cross = plane("curvature.cross");
        forEachHit(target, [&](size_t i, const float* p) { a[i] = p[1], b[i] = p[2], cross[i] = p[3]; });
    }

    /// What no manifest can leave out: the side that is seen, and faults of a search.
    void addFlags(const std::vector<float>& target, bool ofSearch) {
        const auto facing = frame_.add("facing");
        const auto fault = ofSearch ? frame_.add("fault") : std::span<float>(unwanted_);
        forEachHit(target, [&](size_t i, const float* p) {
            const auto flags = static_cast<unsigned>(p[0]) >> kMaxLights;
            facing[i] = flags & 1u ? -1.0f : 1.0f;
            fault[i] = static_cast<float>(flags >> 1);
        });
    }

    void addShadows(const std::vector<float>& target, const std::vector<Light>& lights) {
        if (!wanted("shadow.<light>")) return;
        for (size_t light = 0; light < lights.size(); ++light) {
            const auto shadow = frame_.add(shadowChannel(lights[light].name));
            forEachHit(target, [&](size_t i, const float* p) {
                shadow[i] = static_cast<float>(static_cast<unsigned>(p[0]) >> light & 1u);
            });
        }
    }

    Frame takeFrame() { return std::move(frame_); }

  private:
    bool wanted(std::string_view row) const {
        return channels_.empty() || std::find(channels_.begin(), channels_.end(), row) != channels_.end();
    }
    /// Channels that aren't kept share a scratch plane.
    std::span<float> plane(const char* name) {
        return wanted(name) ? frame_.add(name) : std::span<float>(unwanted_);
    }
    /// Visits the four components of each pixel with rows flipped, because GL's row 0 is the bottom row.
    template <class Store>
    void forEachPixel(const std::vector<float>& target, const Store& store) const {
        const auto columns = static_cast<size_t>(frame_.width()), rows = static_cast<size_t>(frame_.height());
        for (size_t row = 0; row < rows; ++row)
            for (size_t column = 0; column < columns; ++column)
                store(row * columns + column, &target[4 * ((rows - 1 - row) * columns + column)]);
    }
    template <class Store>
    void forEachHit(const std::vector<float>& target, const Store& store) const {
        forEachPixel(target, [&](size_t i, const float* p) {
            if (covered_[i] > 0) store(i, p);
        });
    }

    Frame frame_;
    const std::vector<std::string>& channels_;
    std::vector<float> unwanted_, covered_, heightFetches_;
};

} // namespace

FrameTarget::FrameTarget(const Scene& scene, const GlContext& context)
    : scene_(scene), width_(scene.camera.width), height_(scene.camera.height) {
    if (scene.lights.size() > kMaxLights)
        throw InputError("light", fmt::format("the scene has {} lights", scene.lights.size()),
                         fmt::format("at most {} for real-time frames", kMaxLights));
    checkSize(width_, height_);
    const std::string what =
        fmt::format("a frame of {} x {} pixels and {} lights", width_, height_, scene.lights.size());
    if (context.softwareRasterizer())
        requireMemory(what, kTargetBytesPerPixel * width_ * static_cast<double>(height_));
    clearGlErrors();
    framebuffer_ = GlFramebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    std::array<GLenum, kTargets> buffers{};
    for (int i = 0; i < kTargets; ++i) {
        textures_.push_back(makeTarget(GL_RGBA32F, width_, height_));
        buffers[static_cast<size_t>(i)] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
        glFramebufferTexture2D(GL_FRAMEBUFFER, buffers[static_cast<size_t>(i)], GL_TEXTURE_2D,
                               textures_.back().get(), 0);
    }
    depth_ = makeTarget(GL_DEPTH32F_STENCIL8, width_, height_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depth_.get(), 0);
    glDrawBuffers(kTargets, buffers.data());
    checkGl(what);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw MachineError("OpenGL", fmt::format("{}: framebuffer status {:#x}", what, status));
}

void FrameTarget::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    glViewport(0, 0, width_, height_);
    const GLfloat background[] = {static_cast<float>(scene_.background.x),
                                  static_cast<float>(scene_.background.y),
                                  static_cast<float>(scene_.background.z), 0};
    const GLfloat zero[] = {0, 0, 0, 0};
    for (int i = 0; i < kTargets; ++i)
        glClearBufferfv(GL_COLOR, i, i == kColor ? background : zero);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, kFarthest, 0);
}

void FrameTarget::markNearestBacks(const std::function<void()>& drawPolygons) const {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_ZERO);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_REPLACE);
    drawPolygons();
    glDisable(GL_STENCIL_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &kFarthest);
}

void FrameTarget::drawOnNearestBacks(const std::function<void()>& draw) const {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    draw();
    glDisable(GL_STENCIL_TEST);
}

std::vector<float> FrameTarget::readTarget(int target) const {
    std::vector<float> pixels(4 * static_cast<size_t>(width_) * static_cast<size_t>(height_));
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(target));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
    checkGl("reading the frame back");
    return pixels;
}

Frame FrameTarget::read(const Vec3& originWorld, const std::vector<Vec2>& stOrigins,
                        const Technique& technique) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    const std::vector<float> texture = readTarget(kTexture);
    ChannelSplitter splitter(width_, height_, technique.search.channels, texture);
    splitter.addColor(readTarget(kColor));
    splitter.addPosition(readTarget(kPosition), originWorld);
    splitter.addNormal(readTarget(kNormal));
    splitter.addTexture(texture, stOrigins);
    const std::vector<float> surface = readTarget(kSurface);
    if (technique.hasCurvedBase()) splitter.addCurvature(surface);
    splitter.addFlags(surface, !technique.drawsMicroTriangles());
    splitter.addShadows(surface, scene_.lights);
    return splitter.takeFrame();
}

} // namespace plumbline
