// Caches the manifests of a run by name; each is read once, on first use.
#pragma once

#include "realtime/technique/manifest.h"

#include <map>
#include <string>

namespace plumbline {

class ManifestCache {
  public:
    /// The manifest of a technique by its name or folder. Throws InputError on every call if it is invalid.
    const Manifest& search(const std::string& search);
    /// The manifest of a surface by its name in the library. Throws InputError.
    const Manifest& surface(const std::string& name);

  private:
    std::map<std::string, Manifest> searches_, surfaces_;
};

} // namespace plumbline
