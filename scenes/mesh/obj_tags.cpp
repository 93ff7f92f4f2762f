#include "scenes/mesh/obj_tags.h"

#include "scenes/core/error.h"
#include "scenes/core/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline {
namespace {

/// A parsed `t` line.
struct Tag {
    std::string name;
    std::vector<int> integers;
    std::vector<double> numbers;
    std::vector<std::string> texts;
};

class TagReader {
  public:
    TagReader(const std::string& fileName, int line, ObjTags& result)
        : fileName_(fileName), line_(line), result_(result) {}

    void read(std::span<const std::string_view> words) {
        const Tag tag = split(words);
        const auto handler = std::ranges::find(kHandlers, tag.name, &Handler::name);
        if (handler == kHandlers.end()) {
            std::vector<std::string> names;
            names.reserve(kHandlers.size());
            for (const Handler& each : kHandlers)
                names.emplace_back(each.name);
            fail(fmt::format("subdivision tag '{}' is not supported", shortened(tag.name)), listOf(names),
                 didYouMean(tag.name, names));
        }
        (this->*handler->add)(tag);
    }

  private:
    struct Handler {
        std::string_view name;
        void (TagReader::*add)(const Tag& tag);
    };
    static const std::array<Handler, 8> kHandlers;

    [[noreturn]] void fail(const std::string& what, const std::string& expected = {},
                           const std::string& hint = {}) const {
        throw InputError(fmt::format("{}:{}", fileName_, line_), what, expected, hint);
    }

    template <class Number>
    Number parse(std::string_view word, const char* expected) const {
        const auto number = parseSignedNumber<Number>(word);
        if (!number) fail(fmt::format("'{}' in a subdivision tag", shortened(word)), expected);
        return *number;
    }

    /// Parses "2/1/0", the counts of integers, numbers and words.
    std::array<size_t, 3> parseCounts(std::string_view word) const {
        std::array<size_t, 3> counts{};
        const size_t slash = word.find('/'), slash2 = slash == word.npos ? slash : word.find('/', slash + 1);
        constexpr const char* kExpected = "how many whole numbers/numbers/words follow, as in 2/1/0";
        if (slash2 == word.npos) fail(fmt::format("'{}' in a subdivision tag", shortened(word)), kExpected);
        counts[0] = parse<size_t>(word.substr(0, slash), kExpected);
        counts[1] = parse<size_t>(word.substr(slash + 1, slash2 - slash - 1), kExpected);
        counts[2] = parse<size_t>(word.substr(slash2 + 1), kExpected);
        return counts;
    }

    Tag split(std::span<const std::string_view> words) const {
        if (words.size() < 2) fail("a subdivision tag without its counts", "t crease 2/1/0 …");
        const auto [integers, numbers, texts] = parseCounts(words[1]);
        const size_t there = words.size() - 2;
        // Each count is compared separately first, because the sum of very large counts may overflow.
        if (integers > there || numbers > there || texts > there || integers + numbers + texts != there)
            fail(fmt::format("{} values follow {} in a subdivision tag", there, shortened(words[1])),
                 "as many as its counts state");
        Tag tag{std::string(words[0]), {}, {}, {}};
        for (size_t i = 2; i < words.size(); ++i) {
            if (i < 2 + integers)
                tag.integers.push_back(parse<int>(words[i], "a whole number"));
            else if (i < 2 + integers + numbers)
                tag.numbers.push_back(parse<double>(words[i], "a finite number"));
            else
                tag.texts.emplace_back(words[i]);
        }
        return tag;
    }

    void requireCounts(const Tag& tag, bool good, const char* expected) const {
        if (!good)
            fail(fmt::format("{} with {} whole numbers, {} numbers and {} words", tag.name,
                             tag.integers.size(), tag.numbers.size(), tag.texts.size()),
                 expected);
    }

    /// A tag has one sharpness for all of its elements or one for each.
    static double sharpnessAt(const Tag& tag, size_t i) {
        return tag.numbers.size() == 1 ? tag.numbers[0] : tag.numbers[i];
    }

    void addCrease(const Tag& tag) {
        const size_t edges = tag.integers.empty() ? 0 : tag.integers.size() - 1;
        requireCounts(
            tag, edges > 0 && (tag.numbers.size() == 1 || tag.numbers.size() == edges) && tag.texts.empty(),
            "two vertices or more in a row, and one sharpness or one for each edge");
        for (size_t i = 0; i < edges; ++i)
            result_.tags.creases.push_back(
                {tag.integers[i], tag.integers[i + 1], sharpnessAt(tag, i), line_});
    }

    void addCorner(const Tag& tag) {
        const size_t vertices = tag.integers.size();
        requireCounts(tag,
                      vertices > 0 && (tag.numbers.size() == 1 || tag.numbers.size() == vertices) &&
                          tag.texts.empty(),
                      "one vertex or more, and one sharpness or one for each");
        for (size_t i = 0; i < vertices; ++i)
            result_.tags.corners.push_back({tag.integers[i], sharpnessAt(tag, i), line_});
    }

    void addHole(const Tag& tag) {
        requireCounts(tag, !tag.integers.empty() && tag.numbers.empty() && tag.texts.empty(), "only faces");
        for (const int face : tag.integers)
            result_.tags.holes.push_back({face, line_});
    }

    int oneInteger(const Tag& tag, int most, const char* expected) const {
        requireCounts(tag, tag.integers.size() == 1 && tag.numbers.empty() && tag.texts.empty(),
                      "one whole number");
        if (tag.integers[0] < 0 || tag.integers[0] > most)
            fail(fmt::format("{} {}", tag.name, tag.integers[0]), expected);
        return tag.integers[0];
    }

    /// The values are RenderMan's.
    void setBoundary(const Tag& tag) {
        const int kind = oneInteger(tag, 2,
                                    "0 (faces on the boundary are left out), 1 (the boundary keeps its "
                                    "corners) or 2 (it rounds them)");
        result_.boundaryFacesSupportOnly = kind == 0;
        result_.tags.boundaryCornersRound = kind == 2;
    }

    /// OpenSubdiv also implements Chaikin's rule, but where sharpness varies along a crease, the limit
    /// surfaces of its Bfr and Far differ by 0.2 % of a cube's size (measured with 3.5).
    void refuseChaikin(const Tag& tag) {
        requireCounts(tag, tag.integers.empty() && tag.numbers.empty() && tag.texts.size() == 1, "one word");
        if (tag.texts[0] != "normal")
            fail(fmt::format("creasemethod '{}' is not supported", shortened(tag.texts[0])), "normal");
    }

    /// OpenSubdiv's reader knows the words "catmark" and "smooth". RenderMan's number 0 means the first.
    void refuseSmoothTriangles(const Tag& tag) {
        constexpr const char* kExpected = "catmark: triangles are subdivided like other faces";
        const bool oneWord = tag.texts.size() == 1 && tag.integers.empty();
        const bool oneNumber = tag.texts.empty() && tag.integers.size() == 1;
        requireCounts(tag, tag.numbers.empty() && (oneWord || oneNumber), "one word: catmark");
        const std::string value = oneWord ? tag.texts[0] : std::to_string(tag.integers[0]);
        if (value != "catmark" && value != "0")
            fail(fmt::format("smoothtriangles '{}' is not supported", shortened(value)), kExpected);
    }

    void warnOfFaceVarying(const Tag& tag) {
        result_.warnings.push_back(
            fmt::format("{}:{}: {} is ignored: texture coordinates are linear within each face", fileName_,
                        line_, tag.name));
    }

    const std::string& fileName_;
    int line_;
    ObjTags& result_;
};

const std::array<TagReader::Handler, 8> TagReader::kHandlers{{
    {"crease", &TagReader::addCrease},
    {"corner", &TagReader::addCorner},
    {"hole", &TagReader::addHole},
    {"interpolateboundary", &TagReader::setBoundary},
    {"creasemethod", &TagReader::refuseChaikin},
    {"smoothtriangles", &TagReader::refuseSmoothTriangles},
    {"facevaryinginterpolateboundary", &TagReader::warnOfFaceVarying},
    {"facevaryingpropagatecorners", &TagReader::warnOfFaceVarying},
}};

} // namespace

std::string shortened(std::string_view word) {
    constexpr size_t kShown = 40;
    std::string text(word.substr(0, kShown));
    for (char& c : text)
        if (static_cast<unsigned char>(c) > 0x7e) c = '?';
    return word.size() > kShown ? text + "…" : text;
}

void readObjTag(std::span<const std::string_view> words, const std::string& fileName, int line,
                ObjTags& result) {
    TagReader(fileName, line, result).read(words);
}

} // namespace plumbline
