#include "scenes/core/content_hash.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <array>
#include <fstream>

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
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw InputError(file.string(), "can't be opened for reading");
    std::array<char, 65536> block;
    uint64_t length = 0;
    while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
        XXH3_128bits_update(&state_->xxh, block.data(), static_cast<size_t>(stream.gcount()));
        length += static_cast<uint64_t>(stream.gcount());
    }
    if (stream.bad()) throw InputError(file.string(), "can't be read");
    state_->addLength(length);
}

std::string ContentHash::hexadecimal() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(&state_->xxh);
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

} // namespace plumbline
