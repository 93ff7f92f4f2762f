// Manifests of a run by name, each read when it is first asked for, and once.
#pragma once

#include "realtime/technique/manifest.h"

#include <map>
#include <string>

namespace plumbline {

class ManifestCache {
  public:
    /// Of a technique by its name or folder. Throws InputError, each time it is asked for.
    const Manifest& search(const std::string& search);
    /// Of a surface by its name in the library. Throws InputError.
    const Manifest& surface(const std::string& name);

  private:
    std::map<std::string, Manifest> searches_, surfaces_;
};

} // namespace plumbline
