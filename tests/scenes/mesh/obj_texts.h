// OBJ files given as texts.
#pragma once

#include "scenes/mesh/obj_file.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <string>

namespace plumbline {

inline ControlMesh readText(const std::string& text) {
    const TemporaryFolder folder;
    writeFile(folder / "a.obj", text);
    return readObj(folder / "a.obj");
}

/// The error message without the folder prefix.
inline std::string messageFor(const std::string& text) {
    const std::string message = inputErrorOf([&] { readText(text); });
    return message.substr(std::min(message.size(), message.find("a.obj")));
}

} // namespace plumbline
