// The text of one shader stage, assembled from files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// Throws InputError if the file can't be read or is longer than kMostShaderBytes (read_file.h).
std::string readShader(const std::filesystem::path& file);

/// Text of one shader stage in pieces; each piece keeps the name of the file it came from.
class ShaderSource {
  public:
    /// Appends a file's text. Throws InputError if it can't be read, or like addText.
    void addFile(const std::filesystem::path& file);
    /// Appends text under a name in brackets, such as "(parameters)". Throws InputError if all pieces
    /// together have more than kMostShaderBytes.
    void addText(const std::string& name, const std::string& text);

    /// Everything after a first line `#version VERSION` and `preamble`, each piece after a #line of its own
    /// (kLinesPerFile in shader_log.h).
    std::string assemble(std::string_view version = "410 core", std::string_view preamble = {}) const;
    /// Names by number; 0 is the preamble.
    const std::vector<std::string>& files() const { return files_; }
    /// Name of the last piece: the technique's own.
    const std::string& author() const { return files_.back(); }

  private:
    std::vector<std::string> files_{"(preamble)"};
    std::vector<std::string> texts_{""};
    uint64_t bytes_ = 0; // of all texts
};

} // namespace plumbline
