// The messages between a run and the process that draws its techniques, as values for MessageSocket:
//
//   run -> drawing process      WorkerSetup, then a TechniqueRequest for each technique
//   drawing process -> run      phases when they begin, kPhaseReady first; for each request a result or an
//   error
//
// A result is followed by the planes of its frame. A new field of TechniqueResult needs a line in toJson and
// one in techniqueResult.
#pragma once

#include "realtime/realtime.h"
#include "validate/worker/message_socket.h"

#include <exception>
#include <filesystem>

namespace plumbline {

inline constexpr std::string_view kPhaseReady = "ready"; // scene read, OpenGL started

struct WorkerSetup {
    std::filesystem::path scene;
    std::vector<std::string> sceneChanges; // Scene::changes
    std::string sceneHash;                 // the scene is refused if its hash is different
    GlOptions gl;
    uint64_t memoryBytes = 0; // the process sets itself this limit; 0: none
};
nlohmann::json toJson(const WorkerSetup& setup);
WorkerSetup workerSetup(const nlohmann::json& value);

nlohmann::json toJson(const TechniqueRequest& request);
TechniqueRequest techniqueRequest(const nlohmann::json& value);

/// All except the planes of the frame.
nlohmann::json toJson(const TechniqueResult& result);
/// Creates planes of the right size without values. Throws std::runtime_error for a frame of another size.
TechniqueResult techniqueResult(const nlohmann::json& value, const Vec2i& frameSize);

nlohmann::json phaseReply(std::string_view phase);
nlohmann::json errorReply(const std::exception& error);
void sendResult(const MessageSocket& socket, const TechniqueResult& result);

/// The error of an errorReply: InputError, MachineError or another std::runtime_error; null if the value
/// isn't an errorReply.
std::exception_ptr errorOf(const nlohmann::json& reply);

/// One reply of the drawing process; exactly one of the three is set.
struct WorkerReply {
    std::string phase;
    std::optional<TechniqueResult> result; // complete, with the planes of its frame
    std::exception_ptr error; // InputError, MachineError or another std::runtime_error, with its text
};
/// Throws std::runtime_error for a message that is none of these, or a frame of another size than
/// `frameSize`; other errors as MessageSocket.
WorkerReply receiveReply(const MessageSocket& socket, const Vec2i& frameSize);

} // namespace plumbline
