#include "tests/fuzz/fuzz_targets.h"

#include "realtime/bake/baked_map_file.h"
#include "realtime/technique/manifest.h"
#include "scenes/core/error.h"
#include "scenes/frame/frame_header.h"
#include "scenes/frame/object_info.h"
#include "scenes/image/image_file.h"
#include "scenes/mesh/obj_file.h"
#include "scenes/scene_file/scene_file.h"
#include "tests/temporary_folder.h"
#include "validate/compare/compare.h"
#include "validate/compare/imported_frame.h"
#include "validate/results/history.h"
#include "validate/study/study.h"
#include "validate/worker/message_socket.h"
#include "validate/worker/worker_protocol.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sys/socket.h>
#include <unistd.h>

namespace plumbline {
namespace {

std::string textOf(FuzzInput bytes) {
    return {bytes.begin(), bytes.end()};
}

/// Writes the bytes to a file of that name, which is overwritten each time.
std::filesystem::path fileWith(FuzzInput bytes, const std::string& name) {
    static const TemporaryFolder folder;
    const std::filesystem::path file = folder / name;
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) throw std::runtime_error("can't write " + file.string());
    return file;
}

void scene(FuzzInput bytes) {
    parseScene(fileWith({}, "scene.toml"), textOf(bytes));
}

void obj(FuzzInput bytes) {
    readObj(fileWith(bytes, "mesh.obj"));
}

/// As `compare` does.
void frame(FuzzInput bytes) {
    ImportedFrame imported = readImportedFrame(fileWith(bytes, "frame.exr"), {});
    constexpr int kPixels = 64 * 64; // metrics of larger frames take too long for a fuzzer
    if (imported.frame.width() > kPixels / imported.frame.height()) return;
    const std::optional<Camera> camera = cameraFromHeader(imported.frame, imported.file);
    leftOutFields(imported.frame, imported.file);
    convertFrame(imported, camera);
    const std::vector<ObjectInfo> objects = objectsFromHeader(imported.frame, imported.file);
    compareFrames(imported.frame, imported.frame, objects, camera);
}

void picture(FuzzInput bytes) {
    readImage(fileWith(bytes, "picture"));
}

/// The folder of a manifest, whose shader mentions the parameters of the corpus.
std::filesystem::path manifestFolder(FuzzInput bytes, const std::string& name) {
    const std::filesystem::path folder = fileWith(bytes, name).parent_path();
    std::ofstream(folder / "shader.glsl") << "cone_steps tolerance cone_lookup a b c d\n";
    return folder;
}

void techniqueManifest(FuzzInput bytes) {
    readTechniqueManifest(manifestFolder(bytes, "technique.toml"));
}

void surfaceManifest(FuzzInput bytes) {
    readSurfaceManifest(manifestFolder(bytes, "surface.toml"));
}

void study(FuzzInput bytes) {
    readStudy(fileWith(bytes, "study.toml"));
}

void history(FuzzInput bytes) {
    readHistory("history.jsonl", textOf(bytes));
}

void results(FuzzInput bytes) {
    recordOf("results.json", textOf(bytes), std::nullopt);
}

void cacheFile(FuzzInput bytes) {
    // The key follows the 12 bytes of magic and version; with any other the file would be refused at once.
    std::string key = bytes.size() >= 44 ? textOf(bytes.subspan(12, 32)) : std::string(32, '0');
    if (!readBakedMap(fileWith(bytes, "map.bake"), key)) throw std::runtime_error("damaged");
}

/// A drawing process that sends anything and ends.
void workerReply(FuzzInput bytes) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) throw std::runtime_error("no sockets");
    const MessageSocket socket(ends[0]);
    send(ends[1], bytes.data(), bytes.size(),
         MSG_DONTWAIT | MSG_NOSIGNAL); // what the buffer takes, about 200 kB
    close(ends[1]);
    try {
        for (;;)
            receiveReply(socket, Vec2i(2));
    } catch (const ConnectionLost&) {
    }
}

constexpr std::array kTargets{
    FuzzTarget{"scene", scene},
    FuzzTarget{"obj", obj},
    FuzzTarget{"frame", frame},
    FuzzTarget{"picture", picture},
    FuzzTarget{"technique", techniqueManifest},
    FuzzTarget{"surface", surfaceManifest},
    FuzzTarget{"study", study},
    FuzzTarget{"history", history},
    FuzzTarget{"results", results},
    FuzzTarget{"cache_file", cacheFile},
    FuzzTarget{"worker_reply", workerReply},
};

} // namespace

std::span<const FuzzTarget> fuzzTargets() {
    return kTargets;
}

const FuzzTarget* findFuzzTarget(std::string_view name) {
    const auto found = std::ranges::find(kTargets, name, &FuzzTarget::name);
    return found == kTargets.end() ? nullptr : &*found;
}

} // namespace plumbline
