#include "realtime/technique/glsl_words.h"

#include "realtime/technique/manifest.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace plumbline {
namespace {

// GLSL 4.10 section 3.6 and GLSL ES 3.00 section 3.7, without the sampler and matrix types, which are
// recognized by their prefixes below.
const std::set<std::string> kWords{
    "active", "asm", "atomic_uint", "attribute", "bool", "break", "buffer", "case", "cast", "centroid",
    "class", "coherent", "common", "const", "continue", "default", "discard", "do", "double", "else", "enum",
    "extern", "external", "false", "filter", "fixed", "flat", "float", "for", "goto", "half", "highp", "if",
    "in", "inline", "inout", "input", "int", "interface", "invariant", "layout", "long", "lowp", "main",
    "mediump", "namespace", "noinline", "noperspective", "out", "output", "packed", "partition", "patch",
    "precise", "precision", "public", "readonly", "resource", "restrict", "return", "sample", "shared",
    "short", "sizeof", "smooth", "static", "struct", "subroutine", "superp", "switch", "template", "this",
    "true", "typedef", "uint", "uniform", "union", "unsigned", "using", "varying", "void", "volatile",
    "while", "writeonly",
    // Built-in functions that a parameter would hide.
    "abs", "acos", "all", "any", "asin", "atan", "ceil", "clamp", "cos", "cross", "degrees", "distance",
    "dot", "equal", "exp", "exp2", "floor", "fract", "inverse", "inversesqrt", "length", "log", "log2", "max",
    "min", "mix", "mod", "modf", "normalize", "not", "pow", "radians", "reflect", "refract", "round", "sign",
    "sin", "sqrt", "step", "tan", "texture", "transpose", "trunc"};

const std::set<std::string> kHarnessNames{"filter",
                                          "shadow",
                                          "shadow_bias",
                                          "shadow_map_size",
                                          "shadow_map_bias",
                                          "triangle_bounds",
                                          "depth_correction",
                                          "coefficients",
                                          "reliefDepth",
                                          "reliefPosition",
                                          "traceRelief",
                                          "enterRelief",
                                          "frameAt",
                                          "descentAt",
                                          "hitAt",
                                          "missed",
                                          "ReliefRay",
                                          "ReliefHit",
                                          "ReliefFrame",
                                          "heightMap",
                                          "reliefCell",
                                          "reliefMapSize",
                                          "reliefMapClamps",
                                          "cellOf",
                                          "texelCorners",
                                          "normalAndDepth",
                                          "coneOfCell",
                                          "coneMinOfFour",
                                          "coneBilinear",
                                          "depthBounds",
                                          "countIteration",
                                          "steepestDescent",
                                          "distanceOfVoxel",
                                          "coneOfNearestTexel"};

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Comments become spaces.
std::string withoutComments(const std::string& glsl) {
    std::string text = glsl;
    for (size_t i = 0; i + 1 < text.size();) {
        const bool line = text[i] == '/' && text[i + 1] == '/', block = text[i] == '/' && text[i + 1] == '*';
        if (!line && !block) {
            ++i;
            continue;
        }
        const size_t found = line ? text.find('\n', i) : text.find("*/", i + 2);
        const size_t end = found == std::string::npos ? text.size() : found + (line ? 0 : 2);
        std::fill(text.begin() + static_cast<std::ptrdiff_t>(i),
                  text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
        i = end;
    }
    return text;
}

} // namespace

bool isGlslWord(const std::string& name) {
    for (const char* beginning : {"vec", "bvec", "ivec", "uvec", "dvec", "mat", "dmat", "sampler", "isampler",
                                  "usampler", "image", "iimage", "uimage"})
        if (name.starts_with(beginning) && name.size() > std::string(beginning).size() &&
            std::isdigit(static_cast<unsigned char>(name[std::string(beginning).size()])))
            return true;
    return kWords.count(name) > 0;
}

bool isHarnessName(const std::string& name) {
    for (const char* beginning :
         {"k", "u", "g", "v", "in", "out"}) // constants, uniforms, globals and stage interfaces
        if (const size_t length = std::string(beginning).size();
            name.starts_with(beginning) && name.size() > length &&
            std::isupper(static_cast<unsigned char>(name[length])))
            return true;
    return kHarnessNames.count(name) > 0;
}

std::optional<GlslByte> firstForeignByte(const std::string& glsl) {
    const std::string text = withoutComments(glsl);
    int line = 1;
    for (const char c : text) {
        if (c == '\n') ++line;
        const auto byte = static_cast<unsigned char>(c);
        if (byte == 0 || byte >= 0x80) return GlslByte{line, byte};
    }
    return std::nullopt;
}

bool namesIdentifier(const std::string& glsl, const std::string& name) {
    const std::string text = withoutComments(glsl);
    for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const bool starts = at == 0 || !isWordCharacter(text[at - 1]);
        const size_t end = at + name.size();
        if (starts && (end == text.size() || !isWordCharacter(text[end]))) return true;
    }
    return false;
}

} // namespace plumbline
