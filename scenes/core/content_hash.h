// A fingerprint of texts and files: XXH3, 128 bits. Tells inputs apart and names cached results; not a
// cryptographic hash.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace plumbline {

/// Depends on the contents added, their lengths and their order, not on the names of files.
class ContentHash {
  public:
    ContentHash();
    ~ContentHash();
    ContentHash(const ContentHash&) = delete;
    ContentHash& operator=(const ContentHash&) = delete;

    void add(std::string_view bytes);
    /// Throws InputError if the file can't be read.
    void addFile(const std::filesystem::path& file);
    /// 32 digits, of everything added so far.
    std::string hexadecimal() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace plumbline
