// Messages between processes arrive unchanged or not at all.
#include "scenes/core/error.h"
#include "validate/worker/worker_protocol.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace plumbline {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;

const std::string kLatin1 = "caf\xe9 \xff\x01"; // not UTF-8, as file names and compiler logs may be

json passOn(const json& value) {
    const auto [from, to] = MessageSocket::makePair();
    from.send(value);
    return to.receive();
}

constexpr Vec2i kSize(5, 3); // of the frame of sampleResult()

TechniqueResult sampleResult() {
    TechniqueResult result;
    result.name = "mine@quadric:steps=3";
    result.parameters = {{"steps", "3"}, {kLatin1, kLatin1}};
    result.frame = Frame(5, 3);
    for (const char* name : {"A", "Z", "shadow.sun", "cost.fetches"})
        result.frame.add(name);
    result.frame.channel("A")[7] = 1;
    result.frame.channel("Z")[14] = -0.0f;
    result.frame.channel("shadow.sun")[2] = std::bit_cast<float>(0x7fc12345u); // a NaN with a payload
    result.frame.metadata = {{"technique", "mine"}, {"scene", kLatin1}};
    result.backend = "egl";
    result.renderer = "llvmpipe";
    result.msMedian = 1.0 / 3.0;
    result.msRuns = 25;
    result.timer = "wall clock";
    return result;
}

void expectEqualBits(std::span<const float> a, std::span<const float> b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(std::bit_cast<uint32_t>(a[i]), std::bit_cast<uint32_t>(b[i])) << i;
}

TEST(WorkerProtocol, SetupsAndRequests_RoundTrip) {
    const WorkerSetup setup = workerSetup(passOn(toJson(WorkerSetup{"/a/" + kLatin1 + ".toml",
                                                                    {"x.y=" + kLatin1},
                                                                    "abc",
                                                                    {GlBackend::Osmesa, 3, 0.1},
                                                                    uint64_t(7) << 33})));
    EXPECT_EQ(setup.scene, "/a/" + kLatin1 + ".toml");
    EXPECT_EQ(setup.sceneChanges, std::vector<std::string>{"x.y=" + kLatin1});
    EXPECT_EQ(setup.sceneHash, "abc");
    EXPECT_EQ(setup.gl.backend, GlBackend::Osmesa);
    EXPECT_EQ(setup.gl.device, 3);
    EXPECT_EQ(setup.gl.timingBudgetMs, 0.1);
    EXPECT_EQ(setup.memoryBytes, uint64_t(7) << 33);

    const TechniqueRequest request = techniqueRequest(
        passOn(toJson(TechniqueRequest{"./" + kLatin1, "quadric", {{"steps", "3"}, {"empty", ""}}})));
    EXPECT_EQ(request.search, "./" + kLatin1);
    EXPECT_EQ(request.surface, "quadric");
    EXPECT_EQ(request.settings, (Settings{{"steps", "3"}, {"empty", ""}}));
}

TEST(WorkerProtocol, Results_RoundTrip) {
    const auto [from, to] = MessageSocket::makePair();
    const TechniqueResult sent = sampleResult();
    sendResult(from, sent);
    const WorkerReply reply = receiveReply(to, kSize);
    ASSERT_TRUE(reply.result);
    const TechniqueResult& result = *reply.result;
    EXPECT_EQ(result.name, sent.name);
    EXPECT_EQ(result.parameters, sent.parameters);
    EXPECT_EQ(result.backend, sent.backend);
    EXPECT_EQ(result.renderer, sent.renderer);
    EXPECT_EQ(result.msMedian, sent.msMedian);
    EXPECT_EQ(result.msRuns, sent.msRuns);
    EXPECT_EQ(result.timer, sent.timer);
    EXPECT_EQ(result.frame.width(), 5);
    EXPECT_EQ(result.frame.height(), 3);
    EXPECT_EQ(result.frame.metadata, sent.frame.metadata);
    ASSERT_EQ(result.frame.channelNames(), sent.frame.channelNames());
    for (const std::string& name : sent.frame.channelNames())
        expectEqualBits(result.frame.channel(name), sent.frame.channel(name));
}

TEST(WorkerProtocol, NanTimesAndEmptyFrames_RoundTrip) {
    TechniqueResult sent;
    sent.msMedian = std::nan("");
    const auto [from, to] = MessageSocket::makePair();
    sendResult(from, sent);
    const WorkerReply reply = receiveReply(to, Vec2i(0));
    ASSERT_TRUE(reply.result);
    EXPECT_TRUE(std::isnan(reply.result->msMedian));
    EXPECT_EQ(reply.result->frame.pixelCount(), 0u);
}

template <class Error>
void expectArrives(const Error& error) {
    const auto [from, to] = MessageSocket::makePair();
    from.send(errorReply(error));
    const WorkerReply reply = receiveReply(to, kSize);
    ASSERT_TRUE(reply.error);
    try {
        std::rethrow_exception(reply.error);
    } catch (const std::exception& arrived) {
        EXPECT_EQ(typeid(arrived), typeid(Error));
        EXPECT_STREQ(arrived.what(), error.what());
    }
}

TEST(WorkerProtocol, Errors_KeepTypeAndText) {
    expectArrives(InputError("mine.glsl:3", "'" + kLatin1 + "'; undeclared", "a name", "did you mean 'x'?"));
    expectArrives(MachineError("OpenGL", "nothing works"));
    expectArrives(std::runtime_error("internal: " + kLatin1));
}

TEST(WorkerProtocol, Phases_RoundTrip) {
    const auto [from, to] = MessageSocket::makePair();
    from.send(phaseReply(kPhaseReady));
    from.send(phaseReply(kPhaseDrawing));
    EXPECT_EQ(receiveReply(to, kSize).phase, kPhaseReady);
    const WorkerReply second = receiveReply(to, kSize);
    EXPECT_EQ(second.phase, kPhaseDrawing);
    EXPECT_FALSE(second.result);
    EXPECT_FALSE(second.error);
}

/// The bytes of a result in the protocol.
std::string bytesOf(const TechniqueResult& result) {
    auto [from, to] = MessageSocket::makePair();
    sendResult(from, result);
    from = MessageSocket(-1);
    std::string bytes(1 << 16, '\0');
    size_t size = 0;
    for (ssize_t got = 1; got > 0; size += static_cast<size_t>(got))
        got = ::recv(to.descriptor(), bytes.data() + size, bytes.size() - size, 0);
    return bytes.substr(0, size);
}

/// Receives from an end that sends `bytes` and closes.
WorkerReply receiveBytes(const std::string& bytes) {
    auto [from, to] = MessageSocket::makePair();
    EXPECT_EQ(::send(from.descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
    from = MessageSocket(-1);
    return receiveReply(to, kSize);
}

TEST(WorkerProtocol, TruncatedMessage_IsLostConnection) {
    const std::string bytes = bytesOf(sampleResult());
    ASSERT_GT(bytes.size(), 4u * 5 * 3 * 4);
    ASSERT_TRUE(receiveBytes(bytes).result);
    for (size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(receiveBytes(bytes.substr(0, size)), ConnectionLost) << size;
}

TEST(WorkerProtocol, FrameOfAnotherSize_IsRefused) {
    for (const Vec2i& size : {Vec2i(5, 2), Vec2i(3, 5), Vec2i(0, 3), Vec2i(-1, -1)}) {
        const auto [from, to] = MessageSocket::makePair();
        sendResult(from, sampleResult());
        EXPECT_THROW(receiveReply(to, size), std::runtime_error) << size.x << " x " << size.y;
    }
}

TEST(WorkerProtocol, RandomBytes_AreRefused) {
    const auto message = [](uint64_t size, const std::string& rest) {
        return std::string(reinterpret_cast<const char*>(&size), sizeof size) + rest;
    };
    EXPECT_THROW(receiveBytes(message(uint64_t(1) << 60, "")),
                 std::runtime_error);                               // without allocating memory
    EXPECT_THROW(receiveBytes(message(1, "\xc1")), std::exception); // not valid MessagePack
    EXPECT_THROW(receiveBytes(message(1, "\x80")), std::exception); // an empty object isn't a reply
}

TEST(WorkerProtocol, SendingToClosedEnd_RaisesNoSignal) {
    auto [from, to] = MessageSocket::makePair();
    to = MessageSocket(-1);
    const std::vector<float> numbers(1000);
    EXPECT_THROW(from.send(phaseReply("drawing")), ConnectionLost);
    EXPECT_THROW(from.send(std::span<const float>(numbers)), ConnectionLost);
}

TEST(WorkerProtocol, Wait_EndsByMessageCloseOrTimeout) {
    auto [from, to] = MessageSocket::makePair();
    EXPECT_FALSE(to.waitFor(milliseconds(20)));
    from.send(phaseReply("drawing"));
    EXPECT_TRUE(to.waitFor(milliseconds(10000)));
    (void)receiveReply(to, kSize);
    EXPECT_FALSE(to.waitFor(milliseconds(0)));
    from = MessageSocket(-1);
    EXPECT_TRUE(to.waitFor(milliseconds(10000)));
}

// The descriptor of a child's end is below these; sockets must not reuse a closed stdout of the parent.
TEST(WorkerProtocol, Sockets_AvoidStandardStreams) {
    const auto [from, to] = MessageSocket::makePair();
    EXPECT_GE(std::min(from.descriptor(), to.descriptor()), 10);
}

} // namespace
} // namespace plumbline
