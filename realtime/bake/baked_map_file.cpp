#include "realtime/bake/baked_map_file.h"

#include "scenes/core/content_hash.h"
#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"
#include "scenes/core/read_file.h"
#include "scenes/core/replace_file.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string_view>

namespace plumbline {
namespace {

static_assert(std::endian::native == std::endian::little, "files of baked maps are little-endian");

constexpr std::string_view kMagic = "PLUMBAKE";
constexpr size_t kHashLetters = 32;
constexpr size_t kHeaderBytes =
    kMagic.size() + sizeof(uint32_t) + kHashLetters + 5 * sizeof(uint32_t) + sizeof(double);

/// The sizes in a file's header.
struct Shape {
    uint32_t channels, slices, levels, width, height;

    bool isSensible() const {
        constexpr uint32_t kMaxTexels = 1u << 20; // per side, so that sizes in bytes can't overflow 64 bits
        const auto within = [](uint32_t value, uint32_t most) { return value >= 1 && value <= most; };
        return within(channels, 4) && within(slices, 1024) && within(levels, 32) &&
               within(width, kMaxTexels) && within(height, kMaxTexels);
    }
    uint64_t levelBytes(uint32_t level) const {
        const auto side = [&](uint32_t texels) { return uint64_t(std::max(1u, texels >> level)); };
        return side(width) * side(height) * slices * channels * sizeof(float);
    }
    uint64_t valueBytes() const {
        uint64_t bytes = 0;
        for (uint32_t level = 0; level < levels; ++level)
            bytes += levelBytes(level);
        return bytes;
    }
};

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
T take(std::string_view& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
    return value;
}

std::string headerOf(const std::string& key, const StoredMap& stored) {
    const BakedMap& map = stored.map;
    std::string header(kMagic);
    append(header, uint32_t(kBakedMapFormat));
    header += key;
    for (const size_t number : {size_t(map.channels), size_t(map.slices), map.levels.size(),
                                size_t(map.levels[0].width), size_t(map.levels[0].height)})
        append(header, static_cast<uint32_t>(number));
    append(header, stored.ms);
    return header;
}

std::string_view bytesOf(const std::vector<float>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

/// Returns nothing unless the header has this format and key.
std::optional<Shape> shapeOf(std::string_view header, const std::string& key, double& ms) {
    if (!header.starts_with(kMagic)) return std::nullopt;
    header.remove_prefix(kMagic.size());
    if (take<uint32_t>(header) != uint32_t(kBakedMapFormat) || !header.starts_with(key)) return std::nullopt;
    header.remove_prefix(kHashLetters);
    const auto shape = take<Shape>(header);
    ms = take<double>(header);
    if (!shape.isSensible()) return std::nullopt;
    return shape;
}

BakedMap emptyMap(const Shape& shape) {
    BakedMap map;
    map.channels = static_cast<int>(shape.channels);
    map.slices = static_cast<int>(shape.slices);
    for (uint32_t level = 0; level < shape.levels; ++level)
        map.levels.push_back({static_cast<int>(std::max(1u, shape.width >> level)),
                              static_cast<int>(std::max(1u, shape.height >> level)),
                              std::vector<float>(shape.levelBytes(level) / sizeof(float))});
    return map;
}

bool readInto(InputFile& input, std::span<char> bytes) {
    return input.read(bytes) == bytes.size();
}

} // namespace

void writeBakedMap(const std::filesystem::path& file, const std::string& key, const StoredMap& stored) {
    replaceFile(file, [&](OutputStream& stream) {
        ContentHash hash;
        const auto write = [&](std::string_view bytes) {
            hash.add(bytes);
            stream.write(bytes);
        };
        write(headerOf(key, stored));
        for (const BakedMap::Level& level : stored.map.levels)
            write(bytesOf(level.values));
        stream.write(hash.hexadecimal());
    });
}

std::optional<StoredMap> readBakedMap(const std::filesystem::path& file, const std::string& key) {
    InputFile input(file);
    std::string header(kHeaderBytes, '\0');
    if (!readInto(input, header)) return std::nullopt;
    StoredMap stored;
    const std::optional<Shape> shape = shapeOf(header, key, stored.ms);
    if (!shape || input.size() != kHeaderBytes + shape->valueBytes() + kHashLetters) return std::nullopt;

    requireMemory(file.string(), static_cast<double>(shape->valueBytes()));
    stored.map = emptyMap(*shape);
    ContentHash hash;
    hash.add(header);
    for (BakedMap::Level& level : stored.map.levels) {
        const std::string_view bytes = bytesOf(level.values);
        if (!readInto(input, {reinterpret_cast<char*>(level.values.data()), bytes.size()}))
            return std::nullopt;
        hash.add(bytes);
    }
    std::string checksum(kHashLetters, '\0');
    if (!readInto(input, checksum) || checksum != hash.hexadecimal()) return std::nullopt;
    return stored;
}

} // namespace plumbline
