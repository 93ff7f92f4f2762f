// A fingerprint of texts and files: XXH3, 128 bits. Distinguishes inputs and names cached results; it is not
// a cryptographic hash.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace plumbline {

/// The hash depends on the contents added, their lengths and their order, not on file names.
class ContentHash {
  public:
    ContentHash();
    ~ContentHash();
    ContentHash(const ContentHash&) = delete;
    ContentHash& operator=(const ContentHash&) = delete;

    void add(std::string_view bytes);
    /// Throws InputError if the file can't be read.
    void addFile(const std::filesystem::path& file);
    /// The hash of everything added so far, as 32 hexadecimal digits.
    std::string hexadecimal() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace plumbline
