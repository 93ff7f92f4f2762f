// The number under which a drawing process finds its socket: not stdin, stdout or stderr, so that nothing a
// driver prints gets among the messages.
#pragma once

namespace plumbline {
inline constexpr int kWorkerDescriptor = 3;
}
