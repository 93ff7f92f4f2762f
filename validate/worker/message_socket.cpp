#include "validate/worker/message_socket.h"

#include "scenes/core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace plumbline {
namespace {

/// Of a value; frames are sent as numbers. A larger length means that the stream is corrupt.
constexpr uint64_t kLongestBytes = uint64_t(1) << 26;

/// Follows the values of a message. Reading them takes stack for every level at which they nest.
class NestingCheck : public nlohmann::json_sax<nlohmann::json> {
  public:
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool key(string_t&) override { return true; }
    bool start_object(size_t) override { return enter(); }
    bool start_array(size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    bool parse_error(size_t, const std::string&, const nlohmann::json::exception&) override { return false; }

  private:
    static constexpr int kDeepest = 100; // messages have 4
    bool enter() { return ++depth_ <= kDeepest; }
    bool leave() {
        --depth_;
        return true;
    }
    int depth_ = 0;
};

/// Sockets get numbers above the standard streams, which a caller may have closed, and above the number of
/// the child's end.
constexpr int kLowestDescriptor = 10;

void sendBytes(int descriptor, const void* data, size_t size) {
    const char* bytes = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t sent = ::send(descriptor, bytes, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) throw ConnectionLost();
        bytes += sent;
        size -= static_cast<size_t>(sent);
    }
}

void receiveBytes(int descriptor, void* data, size_t size) {
    char* bytes = static_cast<char*>(data);
    while (size > 0) {
        const ssize_t received = ::recv(descriptor, bytes, size, 0);
        if (received < 0 && errno == EINTR) continue;
        if (received <= 0) throw ConnectionLost();
        bytes += received;
        size -= static_cast<size_t>(received);
    }
}

/// The same socket with a number from kLowestDescriptor on.
MessageSocket moved(int descriptor) {
    const int high = ::fcntl(descriptor, F_DUPFD_CLOEXEC, kLowestDescriptor);
    const int error = errno;
    ::close(descriptor);
    if (high < 0) throw MachineError("a socket", std::strerror(error), "fewer open files");
    return MessageSocket(high);
}

} // namespace

MessageSocket::~MessageSocket() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

MessageSocket& MessageSocket::operator=(MessageSocket&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

std::pair<MessageSocket, MessageSocket> MessageSocket::makePair() {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw MachineError("a socket", std::strerror(errno), "a pair of them");
    MessageSocket second(ends[1]);
    MessageSocket first = moved(ends[0]);
    return {std::move(first), moved(std::exchange(second.descriptor_, -1))};
}

void MessageSocket::send(const nlohmann::json& value) const {
    const std::vector<uint8_t> bytes = nlohmann::json::to_msgpack(value);
    const uint64_t size = bytes.size();
    sendBytes(descriptor_, &size, sizeof size);
    sendBytes(descriptor_, bytes.data(), bytes.size());
}

void MessageSocket::send(std::span<const float> numbers) const {
    sendBytes(descriptor_, numbers.data(), numbers.size_bytes());
}

nlohmann::json MessageSocket::receive() const {
    uint64_t size = 0;
    receiveBytes(descriptor_, &size, sizeof size);
    if (size > kLongestBytes) throw std::runtime_error(fmt::format("a message of {} bytes", size));
    std::vector<uint8_t> bytes(size);
    receiveBytes(descriptor_, bytes.data(), bytes.size());
    NestingCheck nesting;
    if (!nlohmann::json::sax_parse(bytes, &nesting, nlohmann::json::input_format_t::msgpack))
        throw std::runtime_error("a message that can't be read");
    return nlohmann::json::from_msgpack(bytes);
}

void MessageSocket::receive(std::span<float> numbers) const {
    receiveBytes(descriptor_, numbers.data(), numbers.size_bytes());
}

bool MessageSocket::waitFor(std::chrono::milliseconds limit) const {
    pollfd waiting{descriptor_, POLLIN, 0};
    return ::poll(&waiting, 1, static_cast<int>(limit.count())) > 0;
}

} // namespace plumbline
