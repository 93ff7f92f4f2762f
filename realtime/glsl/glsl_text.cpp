#include "realtime/glsl/glsl_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

namespace plumbline {
namespace {

// The numbered types are covered by their beginnings below.
const std::set<std::string_view> kKeywords{
    "active",    "asm",    "atomic_uint", "attribute", "bool",     "break",
    "buffer",    "case",   "cast",        "centroid",  "class",    "coherent",
    "common",    "const",  "continue",    "default",   "discard",  "do",
    "double",    "else",   "enum",        "extern",    "external", "false",
    "filter",    "fixed",  "flat",        "float",     "for",      "goto",
    "half",      "highp",  "if",          "in",        "inline",   "inout",
    "input",     "int",    "interface",   "invariant", "layout",   "long",
    "lowp",      "main",   "mediump",     "namespace", "noinline", "noperspective",
    "out",       "output", "packed",      "partition", "patch",    "precise",
    "precision", "public", "readonly",    "resource",  "restrict", "return",
    "row_major", "sample", "shared",      "short",     "sizeof",   "smooth",
    "static",    "struct", "subroutine",  "superp",    "switch",   "template",
    "this",      "true",   "typedef",     "uint",      "uniform",  "union",
    "unsigned",  "using",  "varying",     "void",      "volatile", "while",
    "writeonly"};

// A global constant of such a name hides the function, which GLSL ES 3.00 forbids (section 4.2.2).
const std::set<std::string_view> kFunctions{
    // Angles, exponentials.
    "radians", "degrees", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh",
    "acosh", "atanh", "pow", "exp", "log", "exp2", "log2", "sqrt", "inversesqrt",
    // Common.
    "abs", "sign", "floor", "trunc", "round", "roundEven", "ceil", "fract", "mod", "modf", "min", "max",
    "clamp", "mix", "step", "smoothstep", "isnan", "isinf", "floatBitsToInt", "floatBitsToUint",
    "intBitsToFloat", "uintBitsToFloat", "fma", "frexp", "ldexp",
    // Packing.
    "packUnorm2x16", "packSnorm2x16", "packHalf2x16", "packUnorm4x8", "packSnorm4x8", "packDouble2x32",
    "unpackUnorm2x16", "unpackSnorm2x16", "unpackHalf2x16", "unpackUnorm4x8", "unpackSnorm4x8",
    "unpackDouble2x32",
    // Vectors and matrices.
    "length", "distance", "dot", "cross", "normalize", "ftransform", "faceforward", "reflect", "refract",
    "matrixCompMult", "outerProduct", "transpose", "determinant", "inverse", "lessThan", "lessThanEqual",
    "greaterThan", "greaterThanEqual", "equal", "notEqual", "any", "all", "not",
    // Integers.
    "uaddCarry", "usubBorrow", "umulExtended", "imulExtended", "bitfieldExtract", "bitfieldInsert",
    "bitfieldReverse", "bitCount", "findLSB", "findMSB",
    // Textures.
    "texture", "textureSize", "textureQueryLod", "textureProj", "textureLod", "textureOffset", "texelFetch",
    "texelFetchOffset", "textureProjOffset", "textureLodOffset", "textureProjLod", "textureProjLodOffset",
    "textureGrad", "textureGradOffset", "textureProjGrad", "textureProjGradOffset", "textureGather",
    "textureGatherOffset", "textureGatherOffsets",
    // Stages.
    "dFdx", "dFdy", "fwidth", "interpolateAtCentroid", "interpolateAtSample", "interpolateAtOffset", "noise1",
    "noise2", "noise3", "noise4", "EmitStreamVertex", "EndStreamPrimitive", "EmitVertex", "EndPrimitive",
    "barrier"};

constexpr std::array<std::string_view, 15> kNumberedTypes{
    "vec",  "bvec",    "ivec",     "uvec",     "dvec",  "hvec",   "fvec",  "mat",
    "dmat", "sampler", "isampler", "usampler", "image", "iimage", "uimage"};

bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// "vec3", "mat2x4", "sampler2DArray", "isamplerCube", "imageBuffer".
bool isNumberedType(std::string_view name) {
    const auto isOf = [&](std::string_view beginning) {
        if (!name.starts_with(beginning)) return false;
        const std::string_view end = name.substr(beginning.size());
        return !end.empty() && (isDigit(end[0]) || end.starts_with("Cube") || end.starts_with("Buffer"));
    };
    return std::ranges::any_of(kNumberedTypes, isOf);
}

} // namespace

bool isNameCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool isGlslWord(std::string_view name) {
    return kKeywords.contains(name) || kFunctions.contains(name) || isNumberedType(name);
}

std::string withoutComments(std::string_view glsl) {
    std::string text(glsl);
    for (size_t i = 0; i + 1 < text.size();) {
        const bool line = text[i] == '/' && text[i + 1] == '/', block = text[i] == '/' && text[i + 1] == '*';
        if (!line && !block) {
            ++i;
            continue;
        }
        const size_t found = line ? text.find('\n', i) : text.find("*/", i + 2);
        const size_t end = found == std::string::npos ? text.size() : found + (line ? 0 : 2);
        for (; i < end; ++i)
            if (text[i] != '\n') text[i] = ' ';
    }
    return text;
}

bool namesIdentifier(std::string_view glsl, std::string_view name) {
    const std::string text = withoutComments(glsl);
    for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const bool starts = at == 0 || !isNameCharacter(text[at - 1]);
        const size_t end = at + name.size();
        if (starts && (end == text.size() || !isNameCharacter(text[end]))) return true;
    }
    return false;
}

std::optional<GlslByte> firstNonAsciiByte(std::string_view glsl) {
    int line = 1;
    for (const char c : withoutComments(glsl)) {
        if (c == '\n') ++line;
        const auto byte = static_cast<unsigned char>(c);
        if (byte == 0 || byte >= 0x80) return GlslByte{line, byte};
    }
    return std::nullopt;
}

} // namespace plumbline
