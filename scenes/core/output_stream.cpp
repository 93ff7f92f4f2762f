#include "scenes/core/output_stream.h"

#include "scenes/core/write_error.h"

#include <cerrno>
#include <unistd.h>

namespace plumbline {
namespace {

constexpr size_t kBufferBytes = size_t(1) << 16;

} // namespace

void OutputStream::write(std::string_view bytes) {
    if (error_ != 0) fail(error_);
    position_ += bytes.size();
    if (buffer_.size() + bytes.size() <= kBufferBytes) {
        buffer_ += bytes;
        return;
    }
    flush();
    writeNow(bytes);
}

void OutputStream::seek(uint64_t position) {
    flush();
    if (::lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail(errno);
    position_ = position;
}

void OutputStream::flush() {
    if (error_ != 0) fail(error_);
    writeNow(buffer_);
    buffer_.clear();
}

void OutputStream::writeNow(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(errno);
        bytes.remove_prefix(static_cast<size_t>(written));
    }
}

void OutputStream::fail(int error) {
    error_ = error;
    failWrite(file_, error);
}

} // namespace plumbline
