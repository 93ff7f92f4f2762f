#include "scenes/mesh/obj_file.h"

#include "scenes/core/contains.h"
#include "scenes/core/error.h"
#include "scenes/core/numbers.h"
#include "scenes/core/read_file.h"
#include "scenes/mesh/obj_tags.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace plumbline {
namespace {

// Grouping, materials and display attributes, which don't affect the surface.
constexpr std::array<std::string_view, 19> kIgnored{
    "o",   "g",     "s",        "mg",       "usemtl", "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj",
    "lod", "bevel", "c_interp", "d_interp", "l",      "p",      "vp",     "ctech",  "stech"};
constexpr std::array<std::string_view, 7> kFreeForm{"cstype", "curv", "curv2", "surf", "deg", "bmat", "fo"};

/// The lines of a text without line endings (LF, CR LF or CR), comments and the byte-order mark. A backslash
/// at the end of a line joins it with the next one.
class LineReader {
  public:
    explicit LineReader(std::string_view text) : rest_(text) {
        if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
    }

    /// False at the end of the text.
    bool next() {
        number_ += linesTaken_;
        linesTaken_ = 0;
        if (rest_.empty()) return false;
        bool continues = false;
        line_ = take(continues);
        if (!continues) return true;
        joined_ = line_;
        while (continues) {
            joined_ += ' ';
            joined_ += take(continues);
        }
        line_ = joined_;
        return true;
    }

    std::string_view line() const { return line_; }
    /// From 1; for joined lines, the number of the first one.
    int number() const { return number_; }

  private:
    std::string_view take(bool& continues) {
        const size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
        std::string_view line = rest_.substr(0, end);
        const bool isLast = end == rest_.size();
        rest_.remove_prefix(end);
        if (!isLast) rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
        ++linesTaken_;
        const size_t comment = line.find('#');
        continues = !isLast && comment == line.npos && line.ends_with('\\');
        if (continues) line.remove_suffix(1);
        return line.substr(0, comment);
    }

    std::string_view rest_, line_;
    std::string joined_;
    int number_ = 1, linesTaken_ = 0;
};

/// The format of a corner (v, v/vt, v//vn or v/vt/vn) and its indices as written.
struct Corner {
    long long vertex = 0, uv = 0, normal = 0;
    bool hasUv = false, hasNormal = false;
};

/// A kind of element that faces refer to by index, with the faces' indices and the largest of them. The
/// largest index is checked at the end of the file, because OBJ may define an element after its use.
struct Elements {
    const char* what;
    long long count = 0;
    long long largestIndex = 0;
    int lineOfLargest = 0;
};

/// uv or normal indices, which are used only if all faces have them.
struct OptionalIndices {
    const char* what;
    bool any = false;
    int lineWithout = 0; // of the first face without indices; 0 if all have them

    void note(bool has, int line) {
        any |= has;
        if (!has && lineWithout == 0) lineWithout = line;
    }
    /// Moves the indices to `indices` if all faces have them. If only some faces do, reports one without them
    /// in `missing`.
    void settle(std::vector<int>& indices, std::string& missing) const {
        if (lineWithout == 0) return;
        indices.clear();
        if (any)
            missing =
                fmt::format("the face in line {} has no {} indices, though others have", lineWithout, what);
    }
};

void normalizeWherePossible(std::vector<Vec3>& normals) {
    for (Vec3& normal : normals)
        if (const double length = glm::length(normal); length > 0) normal /= length;
}

class ObjReader {
  public:
    ObjReader(std::string fileName, std::string_view text) : lines_(text) {
        mesh_.name = std::move(fileName);
    }

    ControlMesh read() {
        while (lines_.next())
            readLine(lines_.line());
        for (const Elements* elements : {&vertices_, &uvs_, &normals_})
            checkLargest(*elements);
        if (mesh_.faceSizes.empty()) throw InputError(mesh_.name, "has no face", "lines that begin with 'f'");
        faceUvs_.settle(mesh_.faceUvs, mesh_.uvsMissing);
        faceNormals_.settle(mesh_.faceNormals, mesh_.normalsMissing);
        normalizeWherePossible(mesh_.normals);
        mesh_.tags = std::move(tags_.tags);
        mesh_.boundaryFacesSupportOnly = tags_.boundaryFacesSupportOnly;
        mesh_.warnings = std::move(tags_.warnings);
        return std::move(mesh_);
    }

  private:
    using Words = std::span<const std::string_view>;

    [[noreturn]] void fail(const std::string& what, const std::string& expected = {},
                           const std::string& hint = {}) const {
        throw InputError(fmt::format("{}:{}", mesh_.name, lines_.number()), what, expected, hint);
    }

    /// Splits into words_, whose memory is reused for every line.
    void split(std::string_view line) {
        words_.clear();
        for (size_t i = line.find_first_not_of(" \t"); i < line.size();) {
            const size_t end = std::min(line.find_first_of(" \t", i), line.size());
            words_.push_back(line.substr(i, end - i));
            i = line.find_first_not_of(" \t", end);
        }
    }

    void readLine(std::string_view line) {
        for (const char c : line)
            if (static_cast<unsigned char>(c) < 0x20 && c != '\t')
                fail("a byte that is not text", "a Wavefront OBJ text file");
        split(line);
        if (words_.empty()) return;
        const std::string_view keyword = words_[0];
        const Words arguments = Words(words_).subspan(1);
        if (keyword == "v") return readElement(vertices_, arguments, mesh_.points);
        if (keyword == "vt") return readElement(uvs_, arguments, mesh_.uvs);
        if (keyword == "vn") return readElement(normals_, arguments, mesh_.normals);
        if (keyword == "f") return readFace(arguments);
        if (contains(kIgnored, keyword)) return;
        if (keyword == "t") return readObjTag(arguments, mesh_.name, lines_.number(), tags_);
        if (contains(kFreeForm, keyword))
            fail(fmt::format("'{}' is not supported", keyword), "polygons ('f')");
        fail(fmt::format("unknown keyword '{}'", shortened(keyword)), "v, vt, vn, f or another OBJ keyword");
    }

    /// Additional values (a weight, a color) are ignored, but must be numbers.
    template <class Vector>
    void readElement(Elements& elements, Words arguments, std::vector<Vector>& into) {
        constexpr size_t kNumbers = Vector::length();
        if (arguments.size() < kNumbers)
            fail(fmt::format("{} numbers for a {}", arguments.size(), elements.what),
                 fmt::format("{}", kNumbers));
        Vector& vector = into.emplace_back();
        for (int axis = 0; axis < Vector::length(); ++axis)
            vector[axis] = readNumber(item(arguments, axis));
        for (const std::string_view more : arguments.subspan(kNumbers))
            readNumber(more);
        ++elements.count;
    }

    /// Numbers too small for a double become 0; they need separate treatment because parseNumber rejects them
    /// like numbers that are too large.
    double readNumber(std::string_view word) const {
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        double value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool tiny = error == std::errc::result_out_of_range && digits.find("e-") != digits.npos;
        if (tiny) return 0;
        if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
            fail(fmt::format("'{}' is not a finite number", shortened(word)), "a decimal number");
        return value;
    }

    long long readIndex(std::string_view word, std::string_view corner) const {
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        const auto index = parseNumber<long long>(digits);
        if (!index)
            fail(fmt::format("'{}' is not a corner of a face", shortened(corner)),
                 "v, v/vt, v//vn or v/vt/vn");
        return *index;
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

    /// The index from 0. OBJ counts from 1, or backwards from the latest element.
    int resolve(Elements& elements, long long index) const {
        if (index == 0)
            fail(fmt::format("{} index 0", elements.what), "1 or more, or a negative one counting back");
        if (index < -elements.count)
            fail(fmt::format("{} index {} is out of range", elements.what, index),
                 fmt::format("-{} to -1 here", elements.count));
        if (index > elements.largestIndex) {
            elements.largestIndex = index;
            elements.lineOfLargest = lines_.number();
        }
        return static_cast<int>(index > 0 ? index - 1 : elements.count + index);
    }

    void checkLargest(const Elements& elements) const {
        if (elements.largestIndex > elements.count)
            throw InputError(fmt::format("{}:{}", mesh_.name, elements.lineOfLargest),
                             fmt::format("{} index {} is out of range", elements.what, elements.largestIndex),
                             fmt::format("1 to {}", elements.count),
                             elements.count == 0 ? fmt::format("the file has no {}", elements.what)
                                                 : std::string());
    }

    void readFace(Words arguments) {
        if (arguments.size() < 3) fail(fmt::format("a face with {} corners", arguments.size()), "3 or more");
        const Corner first = readCorner(arguments[0]);
        for (const std::string_view argument : arguments) {
            const Corner corner = readCorner(argument);
            if (corner.hasUv != first.hasUv || corner.hasNormal != first.hasNormal)
                fail(fmt::format("corners '{}' and '{}' of one face have different kinds of indices",
                                 shortened(arguments[0]), shortened(argument)),
                     "the same kinds on each corner");
            mesh_.faceVertices.push_back(resolve(vertices_, corner.vertex));
            if (corner.hasUv) mesh_.faceUvs.push_back(resolve(uvs_, corner.uv));
            if (corner.hasNormal) mesh_.faceNormals.push_back(resolve(normals_, corner.normal));
        }
        faceUvs_.note(first.hasUv, lines_.number());
        faceNormals_.note(first.hasNormal, lines_.number());
        mesh_.faceSizes.push_back(countOf(arguments));
        mesh_.faceLines.push_back(lines_.number());
    }

    LineReader lines_;
    std::vector<std::string_view> words_;
    ControlMesh mesh_;
    ObjTags tags_;
    Elements vertices_{"vertex"}, uvs_{"uv"}, normals_{"normal"};
    OptionalIndices faceUvs_{"uv"}, faceNormals_{"normal"};
};

} // namespace

ControlMesh readObj(const std::filesystem::path& file) {
    const std::string text = readWholeFile(file);
    ControlMesh mesh = ObjReader(file.string(), text).read();
    checkControlMesh(mesh, Scheme::CatmullClark); // what every scheme requires
    return mesh;
}

} // namespace plumbline
