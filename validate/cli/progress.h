// What a command says on stderr while it works: its progress and its warnings.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

/// Says what is being done, on one line that is overwritten, if stderr is a terminal; else only what is to
/// stay.
class Progress {
  public:
    Progress();
    ~Progress();
    void step(const std::string& what);
    /// A line that stays, terminal or not; the step is said again after it.
    void say(const std::string& line);

  private:
    bool terminal_;
    std::string step_;
};

/// A line "warning: …" each.
void printWarnings(const std::vector<std::string>& warnings);

} // namespace plumbline
