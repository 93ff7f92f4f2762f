// The common part of worker processes, which work for the process that started them.
#pragma once

#include "validate/worker/message_socket.h"

#include <functional>
#include <sys/types.h>

namespace plumbline {

/// Finds the socket to the parent and runs `serve` with it. An exception of `serve` is sent as errorReply,
/// which is the last message. The process ends with the parent, even while a shader runs, leaves signals to
/// it, and prints to stderr only. `command`: the command by which it was started. Throws InputError if the
/// program itself didn't start it. Returns an exit code.
int serveParent(pid_t parent, const char* command, const std::function<void(const MessageSocket&)>& serve);

} // namespace plumbline
