// A technique drawn in a separate process gives the same frames, results and errors as in this process.
#include "scenes/scene_file/scene_file.h"
#include "tests/end_to_end/program.h"
#include "tests/files.h"
#include "tests/realtime/gl_fixture.h"
#include "validate/worker/technique_worker.h"

#include <cstring>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class TechniqueWorkerTest : public test::EndToEnd {
  protected:
    void SetUp() override { scene_ = readScene(writeSmallScene()); }
    WorkerOptions options(const GlOptions& gl = {GlBackend::Auto, -1, 0}) const {
        WorkerOptions result;
        result.sceneFile = folder_ / "small.toml";
        result.sceneHash = scene_.hash;
        result.frameSize = {scene_.camera.width, scene_.camera.height};
        result.gl = gl;
        result.program = PLUMBLINE_PROGRAM;
        return result;
    }
    Scene scene_;
};

std::string messageOf(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return std::string(typeid(error).name()) + " " + error.what();
    }
    return "no error";
}

void expectEqualFrames(const Frame& here, const Frame& there) {
    EXPECT_EQ(here.width(), there.width());
    EXPECT_EQ(here.height(), there.height());
    EXPECT_EQ(here.metadata, there.metadata);
    ASSERT_EQ(here.channelNames(), there.channelNames());
    ASSERT_FALSE(here.channelNames().empty());
    for (const std::string& name : here.channelNames())
        EXPECT_EQ(std::memcmp(here.channel(name).data(), there.channel(name).data(),
                              here.channel(name).size_bytes()),
                  0)
            << name;
}

TEST_F(TechniqueWorkerTest, Results_EqualDrawingInProcess) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    TechniqueWorker worker(options()); // one process for all techniques
    RealtimeRenderer renderer(scene_, options().gl);
    const Settings settings{{"linear_steps", "7"}};
    for (const char* text : {"linear_binary", "linear_binary@quadric:binary_steps=2", "normal_mapping"}) {
        SCOPED_TRACE(text);
        const Technique technique = resolveTechnique(text, settings);
        const TechniqueResult here = renderer.render(technique, nullptr), there = worker.render(technique);
        expectEqualFrames(here.frame, there.frame);
        EXPECT_EQ(here.name, there.name);
        EXPECT_EQ(here.parameters, there.parameters);
        EXPECT_EQ(here.backend, there.backend);
        EXPECT_EQ(here.renderer, there.renderer);
        EXPECT_EQ(here.timer, there.timer);
        EXPECT_EQ(here.msRuns, there.msRuns);
    }
}

TEST_F(TechniqueWorkerTest, Errors_EqualDrawingInProcess) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    TechniqueWorker worker(options());
    RealtimeRenderer renderer(scene_, options().gl);
    std::filesystem::create_directory(folder_ / "mine");
    writeFile(folder_ / "mine/technique.toml",
              "title = 'Mine'\ncitation = 'me'\ninputs = ['height']\nlimits = []\nneeds = []\n");
    writeFile(folder_ / "mine/mine.glsl", "ReliefHit traceRelief(ReliefRay ray) { return nonsense; }\n");
    for (const std::string& text : {(folder_ / "mine").string(), std::string("micro_triangles")}) {
        const Technique technique = resolveTechnique(text);
        const std::string here = messageOf([&] { renderer.render(technique, nullptr); });
        EXPECT_NE(here, "no error");
        EXPECT_EQ(messageOf([&] { worker.render(technique); }), here);
    }
    EXPECT_GT(coveredPixels(worker.render(resolveTechnique("linear_binary")).frame),
              1000u); // the process still draws
}

// Names that double their text 28 times: their expansion takes gigabytes.
TEST_F(TechniqueWorkerTest, MemoryLimit_FailsOneTechnique) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    std::filesystem::create_directory(folder_ / "hungry");
    writeFile(folder_ / "hungry/technique.toml",
              "title = 'Hungry'\ncitation = 'me'\ninputs = ['height']\nlimits = []\nneeds = []\n");
    std::string shader = "#define A0 1.0\n";
    for (int i = 1; i <= 28; ++i)
        shader += fmt::format("#define A{} A{} + A{}\n", i, i - 1, i - 1);
    writeFile(folder_ / "hungry/hungry.glsl",
              shader + "ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, A28); }\n");
    WorkerOptions limited = options();
    limited.memoryBytes = uint64_t(500) << 20;
    TechniqueWorker worker(limited);
    EXPECT_THAT(messageOf([&] { worker.render(resolveTechnique((folder_ / "hungry").string())); }),
                ::testing::AllOf(HasSubstr("MachineError"), HasSubstr("its process ran out of memory"),
                                 HasSubstr("its limit is 0.5 GB")));
    EXPECT_GT(coveredPixels(worker.render(resolveTechnique("linear_binary")).frame), 1000u);
}

TEST_F(TechniqueWorkerTest, MissingDevice_IsMachineError) {
    const GlOptions gl{GlBackend::Egl, 99, 0};
    TechniqueWorker worker(options(gl));
    const std::string here = messageOf([&] { RealtimeRenderer(scene_, gl); });
    EXPECT_THAT(here, HasSubstr("99"));
    EXPECT_EQ(messageOf([&] { worker.waitUntilReady(); }), here);
    EXPECT_EQ(messageOf([&] { worker.render(resolveTechnique("linear_binary")); }),
              here); // a new process was started
}

TEST_F(TechniqueWorkerTest, ExitBetweenTechniques_IsReplacedSilently) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    TechniqueWorker worker(options());
    const Frame first = worker.render(resolveTechnique("linear_binary")).frame;
    const std::vector<pid_t> children = test::childrenOf(getpid());
    ASSERT_EQ(children.size(), 1u);
    ASSERT_EQ(test::sendSignal(children[0], SIGKILL), 0);
    ASSERT_TRUE(test::waitUntil([&] { return test::isGone(children[0]); }, 10));
    expectEqualFrames(first, worker.render(resolveTechnique("linear_binary")).frame);
}

TEST_F(TechniqueWorkerTest, Destruction_LeavesNoProcess) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    {
        TechniqueWorker worker(options());
        worker.waitUntilReady();
    }
    EXPECT_TRUE(test::childrenOf(getpid()).empty());
    { TechniqueWorker worker(options()); } // not even ready
    EXPECT_TRUE(test::childrenOf(getpid()).empty());
}

TEST_F(TechniqueWorkerTest, MissingProgram_IsMachineError) {
    WorkerOptions none = options();
    none.program = folder_ / "nowhere";
    EXPECT_THROW(TechniqueWorker worker(none), MachineError);
    none.program = "/bin/false";
    TechniqueWorker worker(none);
    EXPECT_THAT(messageOf([&] { worker.waitUntilReady(); }), HasSubstr("(exit code 1)"));
}

// Uses scripts instead of the program to simulate unexpected ends. They print messages: the length in eight
// bytes, then MessagePack.
const char* const kReady = R"(printf '\015\0\0\0\0\0\0\0\201\245phase\245ready' >&3)";
const char* const kDrawing = R"(printf '\017\0\0\0\0\0\0\0\201\245phase\247drawing' >&3)";
const char* const kMachineError =
    R"(printf '\030\0\0\0\0\0\0\0\201\245error\202\244kind\001\244text\244lost' >&3)";

class ScriptedWorkerTest : public TechniqueWorkerTest {
  protected:
    /// The result of drawing twice.
    std::vector<std::string> drawTwice(const std::vector<std::string>& script) const {
        std::string text = "#!/bin/sh\n";
        for (const std::string& line : script)
            text += line + "\n";
        writeFile(folder_ / "script", text);
        std::filesystem::permissions(folder_ / "script", std::filesystem::perms::owner_all);
        WorkerOptions scripted = options();
        scripted.program = folder_ / "script";
        scripted.timeLimitSeconds = 1;
        TechniqueWorker worker(scripted);
        std::vector<std::string> messages(2);
        for (std::string& message : messages)
            message = messageOf([&] { worker.render(resolveTechnique("linear_binary")); });
        return messages;
    }
};

std::string asMessage(const std::exception& error) {
    return messageOf([&] {
        if (dynamic_cast<const InputError*>(&error) != nullptr) throw InputError("", error.what());
        throw MachineError("", error.what());
    });
}

TEST_F(ScriptedWorkerTest, ExitBeforeAndWhileDrawing_IsReported) {
    const std::string before =
        asMessage(MachineError("linear_binary", "something ended the process (exit code 7)"));
    const std::string during =
        asMessage(MachineError("linear_binary", "the OpenGL driver ended the process (exit code 7)"));
    EXPECT_THAT(drawTwice({kReady, "exit 7"}), ElementsAre(before, before));
    EXPECT_THAT(drawTwice({kReady, kDrawing, "sleep 0.1", "exit 7"}), ElementsAre(during, during));
}

TEST_F(ScriptedWorkerTest, TimeLimit_HoldsPerTechnique) {
    const std::string stopped =
        asMessage(InputError("linear_binary", "not finished after 1 s and stopped",
                             "a search whose loops terminate", "--time-limit SECONDS raises the limit"));
    EXPECT_THAT(drawTwice({kReady, kDrawing, "exec sleep 60"}), ElementsAre(stopped, stopped));
}

// Baking maps before a technique draws may take minutes.
TEST_F(ScriptedWorkerTest, TimeBeforeDrawing_DoesNotCount) {
    const std::string error = asMessage(MachineError("", "lost"));
    EXPECT_THAT(drawTwice({kReady, "sleep 1.5", kMachineError}), ElementsAre(error, error));
}

// A lost context can't be recovered, so the next technique gets a new process, even if this one hasn't ended.
TEST_F(ScriptedWorkerTest, MachineError_StartsNewProcess) {
    const std::string error = asMessage(MachineError("", "lost"));
    EXPECT_THAT(drawTwice({kReady, kMachineError, "exec sleep 60"}), ElementsAre(error, error));
}

} // namespace
} // namespace plumbline
