// Messages between two processes of this program: a value as MessagePack with its length before it, or an
// array of numbers in its memory layout.
//
// MessagePack rather than JSON text, because paths and compiler logs may contain bytes that aren't UTF-8 and
// times may be NaN; it transmits both unchanged. Both processes run the same program on the same machine, so
// byte order and memory layout are equal.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <span>
#include <stdexcept>
#include <utility>

namespace plumbline {

/// The other end was closed: between two messages, within one, or before it received one.
class ConnectionLost : public std::runtime_error {
  public:
    ConnectionLost() : std::runtime_error("the other process closed the connection") {}
};

/// One end of the connection. Its operations block and never raise SIGPIPE.
class MessageSocket {
  public:
    /// Takes ownership of a connected stream socket.
    explicit MessageSocket(int descriptor) : descriptor_(descriptor) {}
    ~MessageSocket();
    MessageSocket(MessageSocket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    MessageSocket& operator=(MessageSocket&& other) noexcept;

    /// Two connected ends, both close-on-exec. Throws MachineError.
    static std::pair<MessageSocket, MessageSocket> makePair();

    int descriptor() const { return descriptor_; }

    /// All four throw ConnectionLost; receiving a value also throws std::runtime_error for invalid bytes.
    void send(const nlohmann::json& value) const;
    void send(std::span<const float> numbers) const;
    nlohmann::json receive() const;
    void receive(std::span<float> numbers) const;

    /// Waits at most `limit`; returns whether there is something to receive or the other end was closed.
    bool waitFor(std::chrono::milliseconds limit) const;

  private:
    int descriptor_;
};

} // namespace plumbline
