#include "scenes/mesh/obj_scan.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace plumbline {
namespace {

// Grouping, materials and display attributes: nothing of the surface is in them.
constexpr std::array<std::string_view, 19> kIgnored{
    "o",   "g",     "s",        "mg",       "usemtl", "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj",
    "lod", "bevel", "c_interp", "d_interp", "l",      "p",      "vp",     "ctech",  "stech"};
constexpr std::array<std::string_view, 7> kFreeForm{"cstype", "curv", "curv2", "surf", "deg", "bmat", "fo"};

/// Which of v, v/vt, v//vn, v/vt/vn a corner has, and the indices as they stand.
struct Corner {
    long long vertex = 0, uv = 0, normal = 0;
    bool hasUv = false, hasNormal = false;
};

/// Indices above the number of elements so far are checked at the end: OBJ may define them later.
struct PendingIndex {
    long long index;
    int line;
};

struct Elements {
    const char* what;
    int numbers; // that a line must have
    long long count = 0;
    PendingIndex largest{0, 0};
};

/// One kind of line end, no comments, no byte-order mark; a line continued by a backslash is joined, with
/// empty lines after it so that later ones keep their numbers.
std::string normalizedLines(std::string_view text) {
    std::string lines;
    lines.reserve(text.size() + 1);
    size_t joined = 0;
    bool comment = false;
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    const auto lineEndAt = [&](size_t i) -> size_t { // letters of the line end at i, 0 if there is none
        if (i >= text.size() || (text[i] != '\n' && text[i] != '\r')) return 0;
        return text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n' ? 2 : 1;
    };
    for (size_t i = 0; i < text.size(); ++i) {
        if (const size_t length = lineEndAt(i)) {
            lines.append(joined + 1, '\n');
            joined = 0;
            comment = false;
            i += length - 1;
        } else if (text[i] == '\\' && !comment && lineEndAt(i + 1)) {
            lines += ' ';
            ++joined;
            i += lineEndAt(i + 1);
        } else {
            comment |= text[i] == '#';
            if (!comment) lines += text[i];
        }
    }
    return lines;
}

class Scanner {
  public:
    Scanner(const std::string& fileName, std::string& text) : fileName_(fileName), text_(text) {}

    ObjScan run() {
        text_ = normalizedLines(text_);
        std::string_view rest = text_;
        while (!rest.empty()) {
            const size_t end = std::min(rest.find('\n'), rest.size());
            ++line_;
            scanLine(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        for (const Elements* elements : {&vertices_, &uvs_, &normals_})
            checkLargest(*elements);
        if (scan_.faceSizes.empty()) throw InputError(fileName_, "has no face", "lines that begin with 'f'");
        return std::move(scan_);
    }

  private:
    [[noreturn]] void fail(const std::string& what, const std::string& expected = {},
                           const std::string& hint = {}) const {
        throw InputError(fmt::format("{}:{}", fileName_, line_), what, expected, hint);
    }

    std::vector<std::string_view> words(std::string_view line) const {
        std::vector<std::string_view> result;
        size_t i = 0;
        while (true) {
            i = line.find_first_not_of(" \t", i);
            if (i == std::string_view::npos) return result;
            const size_t end = std::min(line.find_first_of(" \t", i), line.size());
            result.push_back(line.substr(i, end - i));
            i = end;
        }
    }

    void scanLine(std::string_view line) {
        for (const char c : line)
            if (static_cast<unsigned char>(c) < 0x20 && c != '\t')
                fail("a byte that is no text", "a Wavefront OBJ text file");
        const auto found = words(line);
        if (found.empty()) return;
        const std::string_view keyword = found[0];
        const std::vector<std::string_view> arguments(found.begin() + 1, found.end());
        if (keyword == "v") return scanNumbers(vertices_, arguments);
        if (keyword == "vt") return scanNumbers(uvs_, arguments);
        if (keyword == "vn") return scanNumbers(normals_, arguments);
        if (keyword == "f") return scanFace(arguments);
        if (std::find(kIgnored.begin(), kIgnored.end(), keyword) != kIgnored.end()) return;
        if (keyword == "t") return scanTag(arguments, line);
        if (std::find(kFreeForm.begin(), kFreeForm.end(), keyword) != kFreeForm.end())
            fail(fmt::format("'{}' is not supported", keyword), "polygons ('f')");
        fail(fmt::format("unknown keyword '{}'", shortened(keyword)), "v, vt, vn, f or another OBJ keyword");
    }

    /// tinyobjloader reads tags too, without checks, so it doesn't get to see them.
    void scanTag(const std::vector<std::string_view>& arguments, std::string_view line) {
        readObjTag(arguments, fileName_, line_, scan_.tags);
        std::fill_n(text_.begin() + (line.data() - text_.data()), line.size(), ' ');
    }

    void scanNumbers(Elements& elements, const std::vector<std::string_view>& arguments) {
        if (arguments.size() < static_cast<size_t>(elements.numbers))
            fail(fmt::format("{} numbers for a {}", arguments.size(), elements.what),
                 fmt::format("{}", elements.numbers));
        for (const std::string_view argument : arguments)
            checkNumber(argument);
        ++elements.count;
    }

    void checkNumber(std::string_view word) const {
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        double value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool tiny =
            error == std::errc::result_out_of_range && digits.find("e-") != std::string_view::npos;
        if (tiny || (error == std::errc{} && end == digits.data() + digits.size() && std::isfinite(value)))
            return;
        fail(fmt::format("'{}' is not a finite number", shortened(word)), "a decimal number");
    }

    long long readIndex(std::string_view word, std::string_view corner) const {
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        long long index = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (error != std::errc{} || end != digits.data() + digits.size())
            fail(fmt::format("'{}' is not a corner of a face", shortened(corner)),
                 "v, v/vt, v//vn or v/vt/vn");
        return index;
    }

    Corner readCorner(std::string_view word) const {
        Corner corner;
        const size_t slash = std::min(word.find('/'), word.size());
        corner.vertex = readIndex(word.substr(0, slash), word);
        if (slash == word.size()) return corner;
        const size_t slash2 = std::min(word.find('/', slash + 1), word.size());
        const std::string_view uv = word.substr(slash + 1, slash2 - slash - 1);
        corner.hasUv = !uv.empty() || slash2 == word.size();
        corner.hasNormal = slash2 < word.size();
        if (corner.hasUv) corner.uv = readIndex(uv, word);
        if (corner.hasNormal) corner.normal = readIndex(word.substr(slash2 + 1), word);
        return corner;
    }

    void checkIndex(Elements& elements, long long index) const {
        if (index == 0)
            fail(fmt::format("{} index 0", elements.what), "1 or more, or a negative one counting back");
        if (index < -elements.count)
            fail(fmt::format("{} index {} is out of range", elements.what, index),
                 fmt::format("-{} to -1 here", elements.count));
        if (index > elements.largest.index) elements.largest = {index, line_};
    }

    void checkLargest(const Elements& elements) const {
        if (elements.largest.index > elements.count)
            throw InputError(
                fmt::format("{}:{}", fileName_, elements.largest.line),
                fmt::format("{} index {} is out of range", elements.what, elements.largest.index),
                fmt::format("1 to {}", elements.count),
                elements.count == 0 ? fmt::format("the file has no {}", elements.what) : std::string());
    }

    void scanFace(const std::vector<std::string_view>& arguments) {
        if (arguments.size() < 3) fail(fmt::format("a face with {} corners", arguments.size()), "3 or more");
        const Corner first = readCorner(arguments[0]);
        for (const std::string_view argument : arguments) {
            const Corner corner = readCorner(argument);
            if (corner.hasUv != first.hasUv || corner.hasNormal != first.hasNormal)
                fail(fmt::format("corners '{}' and '{}' of one face have different kinds of indices",
                                 shortened(arguments[0]), shortened(argument)),
                     "the same kinds on each corner");
            checkIndex(vertices_, corner.vertex);
            if (corner.hasUv) checkIndex(uvs_, corner.uv);
            if (corner.hasNormal) checkIndex(normals_, corner.normal);
        }
        const int face = static_cast<int>(scan_.faceSizes.size());
        if (!first.hasUv && scan_.firstFaceWithoutUvs < 0) scan_.firstFaceWithoutUvs = face;
        if (!first.hasNormal && scan_.firstFaceWithoutNormals < 0) scan_.firstFaceWithoutNormals = face;
        scan_.anyUvs |= first.hasUv;
        scan_.anyNormals |= first.hasNormal;
        scan_.faceSizes.push_back(static_cast<int>(arguments.size()));
        scan_.faceLines.push_back(line_);
    }

    const std::string& fileName_;
    std::string& text_;
    int line_ = 0;
    ObjScan scan_;
    Elements vertices_{"vertex", 3};
    Elements uvs_{"uv", 2};
    Elements normals_{"normal", 3};
};

} // namespace

ObjScan scanObj(const std::string& fileName, std::string& text) {
    return Scanner(fileName, text).run();
}

} // namespace plumbline
