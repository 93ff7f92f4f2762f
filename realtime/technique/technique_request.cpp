#include "realtime/technique/technique_request.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

void parseSettings(const std::string& text, const std::string& list, TechniqueRequest& request) {
    size_t begin = 0;
    while (begin <= list.size()) {
        const size_t end = std::min(list.find(',', begin), list.size());
        const std::string item = list.substr(begin, end - begin);
        const size_t equals = item.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == item.size())
            throw InputError("technique '" + text + "'", fmt::format("'{}' is not a setting", item),
                             "key=value");
        if (!request.settings.emplace(item.substr(0, equals), item.substr(equals + 1)).second)
            throw InputError("technique '" + text + "'",
                             fmt::format("sets '{}' twice", item.substr(0, equals)), "each once");
        begin = end + 1;
    }
}

} // namespace

TechniqueRequest parseTechnique(const std::string& text) {
    // '@' and ':' are only separators after the last '/', so that folder names may contain them.
    const size_t slash = text.rfind('/');
    const size_t tail = slash == std::string::npos ? 0 : slash + 1;
    const size_t colon = text.find(':', tail);
    const std::string pieces = text.substr(0, colon);
    const size_t at = pieces.find('@', tail);

    TechniqueRequest request;
    request.search = pieces.substr(0, at);
    while (request.search.size() > 1 && request.search.back() == '/')
        request.search.pop_back();
    if (at != std::string::npos) request.surface = pieces.substr(at + 1);
    if (request.search.empty() || request.surface.empty())
        throw InputError("technique '" + text + "'",
                         request.search.empty() ? "names no search" : "names no surface",
                         "SEARCH[@SURFACE][:key=value,…]");
    if (colon != std::string::npos) parseSettings(text, text.substr(colon + 1), request);
    return request;
}

} // namespace plumbline
