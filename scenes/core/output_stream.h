// What a file is written with: bytes in order, with buffering and with every failure noticed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace plumbline {

/// Once a write failed, it and every later call throw as failWrite does: also where a library between
/// swallows the first of them.
class OutputStream {
  public:
    /// Doesn't own the descriptor. `file`: for errors.
    OutputStream(int descriptor, std::filesystem::path file)
        : descriptor_(descriptor), file_(std::move(file)) {}

    void write(std::string_view bytes);
    uint64_t position() const { return position_; }
    void seek(uint64_t position);
    /// Writes what is buffered.
    void flush();

    /// For a program that writes the file in place of this one; nothing may be buffered.
    int descriptor() const { return descriptor_; }

  private:
    void writeNow(std::string_view bytes);
    [[noreturn]] void fail(int error);

    int descriptor_;
    std::filesystem::path file_;
    std::string buffer_;
    uint64_t position_ = 0; // of the next byte, buffered ones included
    int error_ = 0;         // errno of the first failure
};

} // namespace plumbline
