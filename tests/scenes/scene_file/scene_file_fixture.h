// A scene file that uses every field, which tests modify.
#pragma once

#include "scenes/image/image_file.h"
#include "scenes/scene_file/scene_file.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <string>

namespace plumbline {

/// Every field of the format once.
inline const char* const kWholeScene = R"(purpose = "A test"
background = [0.1, 0.2, 0.3]

[camera]
position = [0, 1.2, 3]
target = [0, 0.5, 0]
up = [0, 1, 0.5]
fov_y_degrees = 35
width = 64
height = 48

[[light]]
name = "sun"
to_light = [0, 3, 4]

[[light]]
name = "lamp"
position = [1, 2, 3]

[[height_map]]
name = "stone"
file = "maps/stone.png"
stores = "height"
wrap = ["repeat", "clamp"]

[[height_map]]
name = "made"
generate = { kind = "cobbles", size = 16, seed = 3 }

[[object]]
name = "quad"
mesh = "quad.obj"
scheme = "none"
proxy_rate = 2
translate = [1, 2, 3]
rotate_degrees = [10, 20, 30]
scale = 1.5
relief = { map = "stone", depth = 0.08, offset = 0.01, tile = [8, -3], uv_offset = [0.5, 0.25] }
color_map = "maps/stone.png"

[[object]]
name = "torus"
shape = { kind = "torus", major = 1.0, minor = 0.25, segments = [12, 6] }
relief = { constant = 0.5, depth = 0.1 }
color = [0.8, 0.75, 0.7]
)";

inline const char* const kQuad =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";

/// A folder with the files the scene names.
class SceneFile : public testing::Test {
  protected:
    SceneFile() {
        std::filesystem::create_directory(folder_ / "maps");
        writePng(folder_ / "maps/stone.png", 2, 1, {0, 0, 0, 51, 51, 51});
        writeFile(folder_ / "quad.obj", kQuad);
    }

    Scene read(const std::string& text) {
        writeFile(folder_ / "scene.toml", text);
        return readScene(folder_ / "scene.toml");
    }

    /// The error message without the folder prefix.
    std::string messageFor(const std::string& text) {
        const std::string message = inputErrorOf([&] { read(text); });
        const std::string prefix = folder_.path().string() + "/";
        return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
    }

    TemporaryFolder folder_;
};

/// The whole scene with `from` replaced by `to`; `from` must be in it.
inline std::string with(const std::string& from, const std::string& to, std::string text = kWholeScene) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

} // namespace plumbline
