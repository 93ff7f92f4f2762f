#include "realtime/glsl/shader_source.h"

#include "realtime/glsl/shader_log.h"
#include "scenes/core/error.h"
#include "scenes/core/read_file.h"

#include <fmt/format.h>

namespace plumbline {

std::string readShader(const std::filesystem::path& file) {
    return readWholeFile(file, kMostShaderBytes);
}

void ShaderSource::addFile(const std::filesystem::path& file) {
    addText(file.string(), readShader(file));
}

void ShaderSource::addText(const std::string& name, const std::string& text) {
    bytes_ += text.size();
    if (bytes_ > kMostShaderBytes)
        throw InputError(name, fmt::format("makes the source of a shader {} bytes long", bytes_),
                         fmt::format("at most {} in all its files", kMostShaderBytes));
    files_.push_back(name);
    texts_.push_back(text);
}

std::string ShaderSource::assemble(std::string_view version, std::string_view preamble) const {
    std::string text = fmt::format("#version {}\n{}\n", version, preamble);
    for (size_t i = 1; i < texts_.size(); ++i)
        text += fmt::format("#line {}\n{}\n", i * kLinesPerFile + 1, texts_[i]);
    return text;
}

} // namespace plumbline
