// The names refused for parameters are those that a compiler refuses, no fewer and no more.
#include "realtime/gl/gl_objects.h"
#include "realtime/glsl/glsl_text.h"
#include "realtime/technique/baked_family.h"
#include "realtime/technique/reserved_names.h"
#include "realtime/technique/stage_sources.h"
#include "scenes/core/read_file.h"
#include "tests/realtime/gl_fixture.h"

#include <fmt/format.h>

#include <regex>

namespace plumbline {
namespace {

/// One that is put into every file of the harness: any baked map, a curved base.
Technique techniqueOfEverything() {
    Technique technique = resolveTechnique("linear_binary@quadric_nearest");
    for (const BakedFamily& family : bakedFamilies())
        technique.search.inputs.emplace_back(family.kinds.front());
    return technique;
}

/// It with one more parameter for each of the names.
Technique withParameters(Technique technique, const std::set<std::string>& names) {
    for (const std::string& name : names) {
        Technique::Setting setting;
        setting.parameter.name = name;
        setting.parameter.type = setting.value.type = ParameterValue::Type::Bool;
        technique.shaderSettings.push_back(std::move(setting));
    }
    return technique;
}

/// The compiler's log; nothing if it accepts the stage.
std::optional<std::string> refusal(const ShaderSource& fragment) {
    const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
    const std::string text = fragment.assemble();
    const GLchar* pointer = text.c_str();
    glShaderSource(shader, 1, &pointer, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::string log(2000, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteShader(shader);
    if (compiled == GL_TRUE) return std::nullopt;
    return log.c_str();
}

/// Of the camera pass, or of the light pass if the first is accepted.
std::optional<std::string> refusal(const Technique& technique) {
    if (const auto log = refusal(reliefSources(technique, 1).fragment)) return log;
    return refusal(reliefLightSources(technique).fragment);
}

std::set<std::string> wordsOf(const std::string& glsl) {
    const std::string text = withoutComments(glsl);
    const std::regex word("[A-Za-z_]\\w*");
    std::set<std::string> words;
    for (std::sregex_iterator match(text.begin(), text.end(), word), end; match != end; ++match)
        words.insert((*match)[0]);
    return words;
}

TEST(ReservedNames, EveryDeclarationOfTheHarness_ClashesWithAParameter) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const CurrentContext current(*testContext());
    const Technique technique = techniqueOfEverything();
    ASSERT_EQ(refusal(technique), std::nullopt);
    EXPECT_GT(harnessNames().size(), 100u);
    for (const std::string& name : harnessNames()) {
        EXPECT_TRUE(refusal(withParameters(technique, {name}))) << name;
        EXPECT_TRUE(isReserved(name)) << name;
    }
}

TEST(ReservedNames, OtherWordsOfTheHarness_CanBeParameters) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const CurrentContext current(*testContext());
    const Technique technique = techniqueOfEverything();
    const ShaderSource harness = reliefSources(technique, 1).fragment;
    std::set<std::string> free;
    for (const std::string& file : harness.files())
        if (file.starts_with("/") && file.find("/shaders/") != std::string::npos)
            for (const std::string& word : wordsOf(readWholeFile(file)))
                if (!isGlslWord(word) && !isReserved(word) && !word.starts_with("gl_")) free.insert(word);
    EXPECT_GT(free.size(), 100u); // members and locals
    EXPECT_EQ(refusal(withParameters(technique, free)), std::nullopt);
}

} // namespace
} // namespace plumbline
