#include "realtime/technique/manifest_cache.h"

#include "realtime/technique/technique_list.h"

namespace plumbline {

const Manifest& ManifestCache::search(const std::string& search) {
    const auto known = searches_.find(search);
    if (known != searches_.end()) return known->second;
    return searches_.emplace(search, readTechniqueManifest(techniqueFolder(search))).first->second;
}

const Manifest& ManifestCache::surface(const std::string& name) {
    const auto known = surfaces_.find(name);
    if (known != surfaces_.end()) return known->second;
    return surfaces_.emplace(name, readSurfaceManifest(surfacesFolder() / name)).first->second;
}

} // namespace plumbline
