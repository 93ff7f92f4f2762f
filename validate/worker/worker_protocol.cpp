#include "validate/worker/worker_protocol.h"

#include "scenes/core/error.h"

#include <nlohmann/json.hpp>

#include <new>

namespace plumbline {

using nlohmann::json;

namespace {

enum class ErrorKind { Input, Machine, Internal };

ErrorKind kindOf(const std::exception& error) {
    if (dynamic_cast<const InputError*>(&error) != nullptr) return ErrorKind::Input;
    if (dynamic_cast<const MachineError*>(&error) != nullptr) return ErrorKind::Machine;
    return ErrorKind::Internal;
}

std::exception_ptr errorFrom(const json& value) {
    const std::string text = value.at("text");
    switch (value.at("kind").get<ErrorKind>()) {
    case ErrorKind::Input:
        return std::make_exception_ptr(InputError("", text));
    case ErrorKind::Machine:
        return std::make_exception_ptr(MachineError("", text));
    default:
        return std::make_exception_ptr(std::runtime_error(text));
    }
}

json toJson(const Frame& frame) {
    return {{"width", frame.width()},
            {"height", frame.height()},
            {"channels", frame.channelNames()},
            {"metadata", frame.metadata}};
}

Frame emptyFrame(const json& value, const Vec2i& size) {
    if (value.at("width") != size.x || value.at("height") != size.y)
        throw std::runtime_error("a frame of another size");
    Frame frame(size.x, size.y);
    for (const std::string name : value.at("channels")) {
        if (!isFrameChannel(name) || frame.has(name)) throw std::runtime_error("a frame with wrong channels");
        frame.add(name);
    }
    frame.metadata = value.at("metadata");
    return frame;
}

} // namespace

json toJson(const WorkerSetup& setup) {
    return {{"scene", setup.scene.native()},    {"scene_changes", setup.sceneChanges},
            {"scene_hash", setup.sceneHash},    {"gl_backend", setup.gl.backend},
            {"gl_device", setup.gl.device},     {"timing_budget_ms", setup.gl.timingBudgetMs},
            {"memory_bytes", setup.memoryBytes}};
}

WorkerSetup workerSetup(const json& value) {
    WorkerSetup setup;
    setup.scene = value.at("scene").get<std::string>();
    setup.sceneChanges = value.at("scene_changes").get<std::vector<std::string>>();
    setup.sceneHash = value.at("scene_hash");
    setup.gl.backend = value.at("gl_backend");
    setup.gl.device = value.at("gl_device");
    setup.gl.timingBudgetMs = value.at("timing_budget_ms");
    setup.memoryBytes = value.at("memory_bytes");
    return setup;
}

json toJson(const TechniqueRequest& request) {
    return {{"search", request.search}, {"surface", request.surface}, {"settings", request.settings}};
}

TechniqueRequest techniqueRequest(const json& value) {
    return {value.at("search"), value.at("surface"), value.at("settings")};
}

json toJson(const TechniqueResult& result) {
    return {{"name", result.name},           {"parameters", result.parameters},
            {"frame", toJson(result.frame)}, {"backend", result.backend},
            {"renderer", result.renderer},   {"ms_median", result.msMedian},
            {"ms_runs", result.msRuns},      {"timer", result.timer},
            {"bake_ms", result.bakeMs},      {"bake_bytes", result.bakeBytes},
            {"warnings", result.warnings}};
}

TechniqueResult techniqueResult(const json& value, const Vec2i& frameSize) {
    TechniqueResult result;
    result.name = value.at("name");
    result.parameters = value.at("parameters");
    result.frame = emptyFrame(value.at("frame"), frameSize);
    result.backend = value.at("backend");
    result.renderer = value.at("renderer");
    result.msMedian = value.at("ms_median");
    result.msRuns = value.at("ms_runs");
    result.timer = value.at("timer");
    result.bakeMs = value.at("bake_ms");
    result.bakeBytes = value.at("bake_bytes");
    result.warnings = value.at("warnings").get<std::vector<std::string>>();
    return result;
}

json phaseReply(std::string_view phase) {
    return {{"phase", phase}};
}

json errorReply(const std::exception& error) {
    return {{"error", {{"kind", kindOf(error)}, {"text", error.what()}}}};
}

std::exception_ptr errorOf(const json& reply) {
    return reply.contains("error") ? errorFrom(reply.at("error")) : nullptr;
}

void sendResult(const MessageSocket& socket, const TechniqueResult& result) {
    socket.send(json{{"result", toJson(result)}});
    for (const std::string& name : result.frame.channelNames())
        socket.send(result.frame.channel(name));
}

WorkerReply receiveReply(const MessageSocket& socket, const Vec2i& frameSize) {
    try {
        const json value = socket.receive();
        WorkerReply reply;
        reply.error = errorOf(value);
        if (value.contains("phase")) {
            reply.phase = value.at("phase");
        } else if (!reply.error) {
            reply.result = techniqueResult(value.at("result"), frameSize);
            for (const std::string& name : reply.result->frame.channelNames())
                socket.receive(reply.result->frame.channel(name));
        }
        return reply;
    } catch (const json::exception& error) {
        throw std::runtime_error(std::string("the drawing process sent what is no reply: ") + error.what());
    }
}

} // namespace plumbline
