#include "realtime/bake/bake_cache.h"

#include "realtime/bake/baked_map_file.h"
#include "realtime/bake/scale_ratios.h"
#include "scenes/core/content_hash.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> variable(const char* name) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') return std::nullopt;
    return fs::path(value);
}

void addWarning(BakeOutcome& outcome, const std::string& warning) {
    outcome.warning += (outcome.warning.empty() ? "" : "; ") + warning;
}

/// Empty if there is no cache folder.
fs::path fileInCache(const std::string& kind, const std::string& key, BakeOutcome& outcome) {
    const std::optional<fs::path> folder = bakeCacheFolder();
    if (!folder) {
        addWarning(outcome,
                   "baked maps aren't kept: none of PLUMBLINE_CACHE, XDG_CACHE_HOME and HOME is set");
        return {};
    }
    std::error_code error;
    fs::create_directories(*folder, error);
    if (std::error_code ignored; fs::is_directory(*folder, ignored))
        return *folder / fmt::format("{}-{}.bake", kind, key);
    addWarning(outcome, fmt::format("baked maps aren't kept: no folder can be made at '{}' ({})",
                                    folder->string(), error.message()));
    return {};
}

/// Returns whether the map was in the cache.
bool fetch(const fs::path& file, const std::string& key, BakeOutcome& outcome) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(file, ignored))) return false;
    std::optional<StoredMap> stored;
    try {
        stored = readBakedMap(file, key);
        if (!stored)
            addWarning(outcome, fmt::format("{}: is damaged, so the map is baked again", file.string()));
    } catch (const InputError& error) {
        addWarning(outcome, fmt::format("the map is baked again: {}", error.what()));
    }
    if (!stored) return false;
    outcome.map = std::move(stored->map);
    outcome.ms = stored->ms;
    outcome.fromCache = true;
    outcome.file = file;
    return true;
}

void keep(const fs::path& file, const std::string& key, BakeOutcome& outcome) {
    StoredMap stored{std::move(outcome.map), outcome.ms};
    try {
        writeBakedMap(file, key, stored);
        outcome.file = file;
    } catch (const std::runtime_error& error) { // InputError or MachineError
        addWarning(outcome, fmt::format("a baked map isn't kept: {}", error.what()));
    }
    outcome.map = std::move(stored.map);
}

} // namespace

std::optional<fs::path> bakeCacheFolder() {
    if (auto folder = variable("PLUMBLINE_CACHE")) return folder;
    if (const auto caches = variable("XDG_CACHE_HOME"); caches && caches->is_absolute())
        return *caches / "plumbline";
    if (const auto home = variable("HOME")) return *home / ".cache" / "plumbline";
    return std::nullopt;
}

std::string bakeCacheKey(const HeightMap& map, const BakeRequest& request) {
    const BakeKind& kind = bakeKind(request.kind);
    std::string text =
        fmt::format("format {}, {} {}, {} x {}, wrap {} {}", kBakedMapFormat, kind.name, kind.version,
                    map.width(), map.height(), static_cast<int>(map.wrapS()), static_cast<int>(map.wrapT()));
    if (kind.needsScale) {
        const ScaleRatios ratios = scaleRatios(request.scale);
        text += fmt::format(", scale {:a} {:a}", ratios.perWidth, ratios.perHeight);
    }
    if (kind.takesSlices) text += fmt::format(", {} slices", request.slices);
    ContentHash hash;
    hash.add(text);
    const std::vector<float>& depths = map.depths();
    hash.add({reinterpret_cast<const char*>(depths.data()), depths.size() * sizeof(float)});
    return hash.hexadecimal();
}

BakeOutcome bakeCached(const HeightMap& map, const BakeRequest& request) {
    BakeOutcome outcome;
    const std::string key = bakeCacheKey(map, request);
    const fs::path file = fileInCache(request.kind, key, outcome);
    if (file.empty() || !fetch(file, key, outcome)) {
        const auto begin = std::chrono::steady_clock::now();
        outcome.map = bakeMap(map, request);
        outcome.ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        if (!file.empty()) keep(file, key, outcome);
    }
    outcome.map.kind = request.kind;
    outcome.bytes = outcome.map.bytes();
    return outcome;
}

} // namespace plumbline
