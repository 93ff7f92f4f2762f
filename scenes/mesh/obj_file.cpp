#include "scenes/mesh/obj_file.h"

#include "scenes/core/contains.h"
#include "scenes/core/error.h"
#include "scenes/core/numbers.h"
#include "scenes/core/read_file.h"
#include "scenes/mesh/cut_faces.h"
#include "scenes/mesh/obj_lines.h"
#include "scenes/mesh/obj_tags.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace plumbline {
namespace {

// Grouping, materials and display attributes, which don't affect the surface.
constexpr std::array<std::string_view, 19> kIgnored{
    "o",   "g",     "s",        "mg",       "usemtl", "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj",
    "lod", "bevel", "c_interp", "d_interp", "l",      "p",      "vp",     "ctech",  "stech"};
constexpr std::array<std::string_view, 7> kFreeForm{"cstype", "curv", "curv2", "surf", "deg", "bmat", "fo"};

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
    /// Clears the indices unless all faces have them. If only some faces do, reports one without them in
    /// `missing`.
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

/// Keywords that aren't OBJ's, with the lines that have them.
class UnknownKeywords {
  public:
    void add(std::string_view keyword, int line) {
        auto& [firstLine, count] = found_.try_emplace(std::string(keyword), line, 0).first->second;
        ++count;
    }
    /// One warning for each keyword, in the order of the lines; those of a file that is hardly OBJ are
    /// counted together from the eleventh on.
    void addTo(std::vector<std::string>& warnings, const std::string& fileName) const {
        constexpr size_t kShown = 10;
        std::map<int, std::string> byLine;
        for (const auto& [keyword, use] : found_)
            byLine[use.first] = fmt::format(
                "{}:{}: unknown keyword '{}': {} left out", fileName, use.first, shortened(keyword),
                use.second == 1 ? "the line is" : fmt::format("{} lines are", use.second));
        size_t shown = 0;
        for (const auto& [line, warning] : byLine)
            if (++shown <= kShown) warnings.push_back(warning);
        if (shown > kShown)
            warnings.push_back(
                fmt::format("{}: lines of {} more unknown keywords are left out", fileName, shown - kShown));
    }

  private:
    std::map<std::string, std::pair<int, int>, std::less<>> found_; // the first line, how many
};

class ObjReader {
  public:
    ObjReader(std::string fileName, std::string_view text) : lines_(text) {
        mesh_.name = std::move(fileName);
    }

    ControlMesh read() {
        if (const int line = lines_.lineWithZero(); line > 0)
            throw InputError(fmt::format("{}:{}", mesh_.name, line), "a byte that is not text: zero",
                             "a Wavefront OBJ text file");
        while (lines_.next())
            readLine(lines_.line());
        for (const Elements* elements : {&vertices_, &uvs_})
            checkLargest(*elements);
        if (mesh_.faceSizes.empty()) throw InputError(mesh_.name, "has no face", "lines that begin with 'f'");
        faceUvs_.settle(mesh_.faceUvs, mesh_.uvsMissing);
        settleNormals();
        normalizeWherePossible(mesh_.normals);
        mesh_.tags = std::move(tags_.tags);
        mesh_.boundaryFacesSupportOnly = tags_.boundaryFacesSupportOnly;
        mesh_.warnings = std::move(tags_.warnings);
        unknown_.addTo(mesh_.warnings, mesh_.name);
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
        for (size_t i = line.find_first_not_of(kObjBlanks); i < line.size();) {
            const size_t end = std::min(line.find_first_of(kObjBlanks, i), line.size());
            words_.push_back(line.substr(i, end - i));
            i = line.find_first_not_of(kObjBlanks, end);
        }
    }

    void readLine(std::string_view line) {
        for (const char c : line)
            if (static_cast<unsigned char>(c) < 0x20 && !contains(kObjBlanks, c))
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
        unknown_.add(keyword, lines_.number());
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

    double readNumber(std::string_view word) const {
        const auto value = parseSignedNumber<double>(word);
        if (!value)
            fail(fmt::format("'{}' is not a finite number", shortened(word)),
                 "a decimal number, 0 or of a size from 5e-324 to 1.7e308");
        return *value;
    }

    long long readIndex(std::string_view word, std::string_view corner) const {
        const auto index = parseSignedNumber<long long>(word);
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

    /// Like resolve(), but for normals, which not every scheme uses: a bad index is kept for the message of
    /// the one that does.
    int resolveNormal(long long index) {
        if (index != 0 && index >= -normals_.count) return resolve(normals_, index);
        noteBadNormal(index, lines_.number());
        return 0;
    }

    void noteBadNormal(long long index, int line) {
        badNormal_ =
            fmt::format("the face in line {} has the normal index {}, which is out of range", line, index);
    }

    void settleNormals() {
        faceNormals_.settle(mesh_.faceNormals, mesh_.normalsMissing);
        if (normals_.largestIndex > normals_.count)
            noteBadNormal(normals_.largestIndex, normals_.lineOfLargest);
        if (badNormal_.empty()) return;
        mesh_.faceNormals.clear();
        mesh_.normalsMissing = badNormal_;
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
            if (corner.hasNormal) mesh_.faceNormals.push_back(resolveNormal(corner.normal));
        }
        faceUvs_.note(first.hasUv, lines_.number());
        faceNormals_.note(first.hasNormal, lines_.number());
        mesh_.faceSizes.push_back(countOf(arguments));
        mesh_.faceLines.push_back(lines_.number());
    }

    ObjLines lines_;
    std::vector<std::string_view> words_;
    ControlMesh mesh_;
    ObjTags tags_;
    Elements vertices_{"vertex"}, uvs_{"uv"}, normals_{"normal"};
    OptionalIndices faceUvs_{"uv"}, faceNormals_{"normal"};
    std::string badNormal_; // a normal index that isn't one; empty if all are
    UnknownKeywords unknown_;
};

} // namespace

ControlMesh readObj(const std::filesystem::path& file) {
    const std::string text = readWholeFile(file);
    ControlMesh mesh = ObjReader(file.string(), text).read();
    repairFaces(mesh);
    checkControlMesh(mesh, Scheme::CatmullClark); // what every scheme requires
    return mesh;
}

} // namespace plumbline
