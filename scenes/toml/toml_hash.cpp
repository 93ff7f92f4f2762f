#include "scenes/toml/toml_hash.h"

#include <fmt/format.h>

#include <optional>

namespace plumbline {
namespace {

// Each value is added with its type and, if it has elements, their number, so that different trees give
// different byte sequences.
class TreeHasher {
  public:
    explicit TreeHasher(ContentHash& hash) : hash_(hash) {}

    void add(const TomlNode& node, std::optional<std::string_view> except = std::nullopt) {
        hash_.add(fmt::format("table of {}", node.values.size() - (except ? node.values.count(*except) : 0)));
        for (const auto& [key, value] : node.values) {
            if (except && key == *except) continue;
            hash_.add(key);
            std::visit(*this, value.content);
        }
    }

    void operator()(std::monostate) { hash_.add("date"); }
    void operator()(bool value) { hash_.add(value ? "true" : "false"); }
    /// 40 and 40.0 are the same number.
    void operator()(int64_t value) {
        constexpr int64_t kExactInDouble = int64_t(1) << 53;
        if (value >= -kExactInDouble && value <= kExactInDouble)
            (*this)(static_cast<double>(value));
        else
            hash_.add(fmt::format("integer {}", value));
    }
    void operator()(double value) {
        hash_.add(fmt::format("number {}", value == 0 ? 0.0 : value)); // round-trips
    }
    void operator()(const std::string& value) { hash_.add("text " + value); }
    void operator()(const TomlValue::Array& values) {
        hash_.add(fmt::format("array of {}", values.size()));
        for (const TomlValue& value : values)
            std::visit(*this, value.content);
    }
    void operator()(const std::shared_ptr<TomlNode>& node) { add(*node); }

  private:
    ContentHash& hash_;
};

} // namespace

void addTree(ContentHash& hash, const TomlNode& root, std::string_view except) {
    TreeHasher(hash).add(root, except);
}

} // namespace plumbline
