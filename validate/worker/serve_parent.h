// The frame of a process that works for the one that started it.
#pragma once

#include "validate/worker/message_socket.h"

#include <functional>
#include <sys/types.h>

namespace plumbline {

/// Finds the socket to the parent and runs `serve` with it. What that throws is the last thing sent, as
/// errorReply; the process ends with the parent, also in the middle of a shader, leaves signals to it, and
/// prints to stderr only. `command`: what it was started as. Throws InputError if no program of this project
/// started it. Returns an exit code.
int serveParent(pid_t parent, const char* command, const std::function<void(const MessageSocket&)>& serve);

} // namespace plumbline
