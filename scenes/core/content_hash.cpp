#include "scenes/core/content_hash.h"

#include "scenes/core/read_file.h"

#include <fmt/format.h>

#include <array>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace plumbline {

struct ContentHash::State {
    XXH3_state_t xxh;
    /// Each piece is followed by its length, so that moving bytes from one piece to the next changes the
    /// hash.
    void addLength(uint64_t length) { XXH3_128bits_update(&xxh, &length, sizeof length); }
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) {
    XXH3_128bits_reset(&state_->xxh);
}

ContentHash::~ContentHash() = default;

void ContentHash::add(std::string_view bytes) {
    XXH3_128bits_update(&state_->xxh, bytes.data(), bytes.size());
    state_->addLength(bytes.size());
}

void ContentHash::addFile(const std::filesystem::path& file) {
    InputFile input(file);
    std::array<char, 65536> block;
    while (const size_t count = input.read(block))
        XXH3_128bits_update(&state_->xxh, block.data(), count);
    input.checkUnchanged();
    state_->addLength(input.position());
}

std::string ContentHash::hexadecimal() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(&state_->xxh);
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

} // namespace plumbline
