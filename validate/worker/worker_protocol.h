// The messages between a run and the process that draws its techniques, as values for MessageSocket.
//
//   run     -> drawing process: WorkerSetup, then a TechniqueRequest a technique
//   drawing process -> run:     phases as it comes to them, kPhaseReady first; for each request a result or
//   an error
//
// A result is followed by its frame's planes. A field more in TechniqueResult is one line in each of the two
// functions.
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
    std::string sceneHash;                 // the scene is refused if it has another by now
    GlOptions gl;
};
nlohmann::json toJson(const WorkerSetup& setup);
WorkerSetup workerSetup(const nlohmann::json& value);

nlohmann::json toJson(const TechniqueRequest& request);
TechniqueRequest techniqueRequest(const nlohmann::json& value);

/// All but the frame's planes; reading gives planes of the right size, not yet filled.
nlohmann::json toJson(const TechniqueResult& result);
TechniqueResult techniqueResult(const nlohmann::json& value);

nlohmann::json phaseReply(std::string_view phase);
nlohmann::json errorReply(const std::exception& error);
void sendResult(const MessageSocket& socket, const TechniqueResult& result);

/// The error of an errorReply: InputError, MachineError or another std::runtime_error; null if the value is
/// something else.
std::exception_ptr errorOf(const nlohmann::json& reply);

/// One reply of the drawing process: exactly one of the three is there.
struct WorkerReply {
    std::string phase;
    std::optional<TechniqueResult> result; // whole
    std::exception_ptr error; // InputError, MachineError or another std::runtime_error, with its text
};
WorkerReply receiveReply(const MessageSocket& socket);

} // namespace plumbline
