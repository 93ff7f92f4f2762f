// Whole messages between two processes of this program: a value as MessagePack behind its length, or numbers
// as they lie in memory.
//
// MessagePack and not JSON text: paths and compiler logs hold bytes that aren't UTF-8, times may be NaN, and
// both arrive as they were. The processes share machine and program, so byte order and layout need no care.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <span>
#include <stdexcept>
#include <utility>

namespace plumbline {

/// The other end is gone: between two messages, in the middle of one, or before it took one.
class ConnectionLost : public std::runtime_error {
  public:
    ConnectionLost() : std::runtime_error("the other process closed the connection") {}
};

/// One end. Blocks; never raises SIGPIPE.
class MessageSocket {
  public:
    /// Takes ownership of a connected stream socket.
    explicit MessageSocket(int descriptor) : descriptor_(descriptor) {}
    ~MessageSocket();
    MessageSocket(MessageSocket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    MessageSocket& operator=(MessageSocket&& other) noexcept;

    /// Two connected ends, both closed in programs that are started. Throws MachineError.
    static std::pair<MessageSocket, MessageSocket> makePair();

    int descriptor() const { return descriptor_; }

    /// All four throw ConnectionLost; receiving a value also std::runtime_error for bytes that are none.
    void send(const nlohmann::json& value) const;
    void send(std::span<const float> numbers) const;
    nlohmann::json receive() const;
    void receive(std::span<float> numbers) const;

    /// Whether something came, the end included, before `limit` was over.
    bool waitFor(std::chrono::milliseconds limit) const;

  private:
    int descriptor_;
};

} // namespace plumbline
