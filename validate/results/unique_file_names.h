// Different file names for different names, in one folder.
#pragma once

#include <set>
#include <string>

namespace plumbline {

class UniqueFileNames {
  public:
    /// A safe name (safeFileName in output_files.h), with a number behind it if it was given out before.
    /// Names that differ in case only count as equal, as they are on some file systems.
    std::string add(const std::string& safeName);

  private:
    std::set<std::string> taken_; // in lower case
};

} // namespace plumbline
