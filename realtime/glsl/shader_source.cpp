#include "realtime/glsl/shader_source.h"

#include "realtime/glsl/shader_log.h"
#include "scenes/core/read_file.h"

#include <fmt/format.h>

namespace plumbline {

void ShaderSource::addFile(const std::filesystem::path& file) {
    addText(file.string(), readWholeFile(file));
}

void ShaderSource::addText(const std::string& name, const std::string& text) {
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
