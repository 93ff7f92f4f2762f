#include "scenes/core/removed_at_signal.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <sys/file.h>
#include <unistd.h>

namespace plumbline {
namespace {

enum class State : int { Free, Changing, Named };

/// A handler may neither allocate nor lock, so there is room for as many files as one run has at a time.
struct Slot {
    std::atomic<State> state{State::Free};
    int folder = -1, shared = -1;
    std::array<char, 64> name{};
};
static_assert(std::atomic<State>::is_always_lock_free);

std::array<Slot, 64> slots; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): for the handler

void removeFiles(int signal) {
    for (const Slot& slot : slots) {
        if (slot.state != State::Named) continue;
        if (slot.shared < 0 || ::flock(slot.shared, LOCK_EX | LOCK_NB) == 0)
            ::unlinkat(slot.folder, slot.name.data(), 0);
    }
    // Ends the process as the signal does by itself; it is delivered when this returns.
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

/// Signals that are ignored, as in a worker process, stay so.
void installHandlers() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        struct sigaction before {};
        if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
        struct sigaction action {};
        action.sa_handler = removeFiles;
        ::sigaction(signal, &action, nullptr);
    }
}

int takeSlot() {
    for (size_t i = 0; i < slots.size(); ++i) {
        State expected = State::Free;
        if (slots[i].state.compare_exchange_strong(expected, State::Changing)) return static_cast<int>(i);
    }
    return -1;
}

} // namespace

RemovedAtSignal::RemovedAtSignal(int folder, const std::string& name, int shared) : slot_(takeSlot()) {
    static std::once_flag installed;
    std::call_once(installed, installHandlers);
    if (slot_ < 0) return;
    Slot& slot = slots[static_cast<size_t>(slot_)];
    if (name.size() >= slot.name.size()) {
        slot.state = State::Free;
        slot_ = -1;
        return;
    }
    std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
    slot.folder = folder;
    slot.shared = shared;
    slot.state = State::Named;
}

RemovedAtSignal::~RemovedAtSignal() {
    if (slot_ >= 0) slots[static_cast<size_t>(slot_)].state = State::Free;
}

} // namespace plumbline
