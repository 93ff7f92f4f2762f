#include "realtime/glsl/glsl_declarations.h"

#include "realtime/glsl/glsl_text.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <vector>

namespace plumbline {
namespace {

bool isLetter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}

using Tokens = std::span<const std::string_view>;

/// Takes preprocessor lines out of the text, and the names of macros into `names`.
std::string withoutDirectives(std::string text, std::set<std::string>& names) {
    constexpr std::string_view kDefine = "define";
    for (size_t at = 0; at < text.size();) {
        size_t end = text.find('\n', at);
        if (end == std::string::npos) end = text.size();
        const size_t first = text.find_first_not_of(" \t", at);
        if (first < end && text[first] == '#') {
            while (end < text.size() && text[end - 1] == '\\') // goes on in the next line
                end = std::min(text.find('\n', end + 1), text.size());
            const std::string_view line(text.data() + first + 1, end - first - 1);
            const size_t word = line.find_first_not_of(" \t");
            if (word != std::string_view::npos && line.substr(word).starts_with(kDefine)) {
                const size_t start = line.find_first_not_of(" \t", word + kDefine.size());
                size_t stop = start;
                while (stop < line.size() && isNameCharacter(line[stop]))
                    ++stop;
                if (stop > start) names.emplace(line.substr(start, stop - start));
            }
            std::fill(text.begin() + static_cast<std::ptrdiff_t>(at),
                      text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
        }
        at = end + 1;
    }
    return text;
}

/// Words and numbers whole, every other character by itself.
std::vector<std::string_view> tokensOf(std::string_view text) {
    std::vector<std::string_view> tokens;
    for (size_t i = 0; i < text.size();) {
        size_t end = i + 1;
        if (isNameCharacter(text[i]))
            while (end < text.size() && (isNameCharacter(text[end]) || text[end] == '.'))
                ++end;
        if (!std::isspace(static_cast<unsigned char>(text[i]))) tokens.push_back(text.substr(i, end - i));
        i = end;
    }
    return tokens;
}

/// The index behind the bracket that closes the one at `open`.
size_t behindGroup(Tokens tokens, size_t open) {
    int depth = 0;
    for (size_t i = open; i < tokens.size(); ++i) {
        const char c = tokens[i][0];
        if (c == '(' || c == '[' || c == '{') ++depth;
        if ((c == ')' || c == ']' || c == '}') && --depth == 0) return i + 1;
    }
    return tokens.size();
}

/// Declarators such as `a, b[3] = x, c`: the words in front of each.
void addDeclarators(Tokens tokens, std::set<std::string>& names) {
    bool inValue = false;
    std::string_view last;
    const auto end = [&] {
        if (!last.empty() && !isGlslWord(last)) names.emplace(last);
        last = {};
        inValue = false;
    };
    for (size_t i = 0; i < tokens.size();) {
        const char c = tokens[i][0];
        if (c == '(' || c == '[' || c == '{') {
            i = behindGroup(tokens, i);
            continue;
        }
        if (c == ',') end();
        if (c == '=') inValue = true;
        if (isLetter(c) && !inValue) last = tokens[i];
        ++i;
    }
    end();
}

/// The members of a structure or block: declarations that end with ';'.
void addMembers(Tokens tokens, std::set<std::string>& names) {
    size_t start = 0;
    for (size_t i = 0; i < tokens.size(); ++i)
        if (tokens[i] == ";") {
            addDeclarators(tokens.subspan(start, i - start), names);
            start = i + 1;
        }
}

/// One declaration without its ';'. `brace`: where its '{' is, tokens.size() if it has none.
void addDeclaration(Tokens tokens, size_t brace, std::set<std::string>& names) {
    if (tokens.empty() || tokens[0] == "precision") return;
    if (brace == tokens.size()) {
        addDeclarators(tokens, names);
        return;
    }
    names.emplace(tokens[brace - 1]);
    const size_t behind = behindGroup(tokens, brace);
    const bool isStructure = brace >= 2 && tokens[brace - 2] == "struct";
    const Tokens declarators = tokens.subspan(behind);
    if (!isStructure && declarators.empty()) addMembers(tokens.subspan(brace + 1, behind - brace - 2), names);
    addDeclarators(declarators, names);
}

} // namespace

std::set<std::string> fileScopeNames(std::string_view glsl) {
    std::set<std::string> names;
    const std::string text = withoutDirectives(withoutComments(glsl), names);
    const std::vector<std::string_view> all = tokensOf(text);
    const Tokens tokens(all);
    size_t start = 0;
    constexpr size_t kNone = std::string_view::npos;
    size_t brace = kNone;
    for (size_t i = 0; i < tokens.size();) {
        const char c = tokens[i][0];
        if (c == '{' && i > start && tokens[i - 1] == ")") { // a function's body
            addDeclaration(tokens.subspan(start, i - start), i - start, names);
            i = start = behindGroup(tokens, i);
        } else if (c == '{') {
            if (brace == kNone && i > start && isLetter(tokens[i - 1][0])) brace = i; // else a value's
            i = behindGroup(tokens, i);
        } else if (c == '(' || c == '[') {
            i = behindGroup(tokens, i);
        } else if (c == ';') {
            const Tokens declaration = tokens.subspan(start, i - start);
            addDeclaration(declaration, brace == kNone ? declaration.size() : brace - start, names);
            brace = kNone;
            start = ++i;
        } else {
            ++i;
        }
    }
    return names;
}

} // namespace plumbline
