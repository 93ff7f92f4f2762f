#include "scenes/toml/toml_key_depth.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace plumbline {
namespace {

constexpr int kMaxParts = 1000;

/// The position after the single-line or multi-line string that begins at `begin`.
size_t endOfString(std::string_view text, size_t begin) {
    const char quote = text[begin];
    const std::string three(3, quote);
    const bool manyLines = text.substr(begin, 3) == three;
    const std::string_view delimiter = std::string_view(three).substr(0, manyLines ? 3 : 1);
    size_t at = begin + delimiter.size();
    while (at < text.size()) {
        if (text[at] == '\\' && quote == '"') {
            at += 2;
        } else if (text.substr(at, delimiter.size()) == delimiter) {
            at += delimiter.size();
            for (int more = 0; manyLines && more < 2 && at < text.size() && text[at] == quote; ++more)
                ++at; // the string's last characters are quotes
            return at;
        } else if (text[at] == '\n' && !manyLines) {
            return at;
        } else {
            ++at;
        }
    }
    return text.size();
}

/// Counts the parts of the open tables' keys and of the key being read.
class KeyDepth {
  public:
    int parts() const { return outer_ + dots_; }

    void add(char c) {
        if (c == '.') {
            ++dots_;
            return;
        }
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == ' ' || c == '\t')
            return; // still the same key
        if (c == '=') ofKey_ = dots_ + 1;
        if (c == '{') {
            open_.push_back(ofKey_);
            outer_ += ofKey_;
        } else if (c == '}' && !open_.empty()) {
            ofKey_ = open_.back(); // also for the next table of an array
            outer_ -= ofKey_;
            open_.pop_back();
        }
        dots_ = 0;
    }

  private:
    std::vector<int> open_;
    int outer_ = 0, ofKey_ = 0, dots_ = 0;
};

} // namespace

void checkKeyDepth(const std::string& where, std::string_view text) {
    KeyDepth depth;
    for (size_t at = 0; at < text.size();) {
        if (text[at] == '"' || text[at] == '\'') {
            at = endOfString(text, at);
        } else if (text[at] == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else {
            depth.add(text[at++]);
            if (depth.parts() > kMaxParts)
                throw InputError(where,
                                 fmt::format("has keys of more than {} parts within each other", kMaxParts),
                                 "a few");
        }
    }
}

} // namespace plumbline
