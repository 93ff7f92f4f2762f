#include "scenes/core/read_file.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <fstream>

namespace plumbline {

std::string readWholeFile(const std::filesystem::path& file) {
    constexpr uintmax_t kLongest = uintmax_t(1) << 30;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw InputError(file.string(), "no such file");
    if (!std::filesystem::is_regular_file(file, error)) throw InputError(file.string(), "is not a file");
    const uintmax_t size = std::filesystem::file_size(file, error);
    if (size > kLongest)
        throw InputError(file.string(), fmt::format("is {} bytes long", size), "at most 2^30");
    std::ifstream stream(file, std::ios::binary);
    std::string text(size, '\0');
    if (!stream || !stream.read(text.data(), static_cast<std::streamsize>(size)))
        throw InputError(file.string(), "can't be read");
    if (text.empty()) throw InputError(file.string(), "is empty");
    return text;
}

} // namespace plumbline
