// Resolving techniques by name, without OpenGL.
#include "realtime/technique/technique.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(TechniqueRequest, RequestOfTechnique_ResolvesToEqualTechnique) {
    for (const char* text : {"linear_binary@quadric:linear_steps=33,tolerance=0.001,shadow=map",
                             "cone_step_relaxed:refine=secant", "micro_triangles"}) {
        const Technique technique = resolveTechnique(text, {{"shadow_bias", "0.3"}});
        const Technique again = resolveTechnique(technique.request());
        EXPECT_EQ(again.name(), technique.name());
        EXPECT_EQ(again.parameters(), technique.parameters());
        EXPECT_EQ(again.glslConstants(), technique.glslConstants());
    }
}

TEST(ManifestCache, RepeatedLookup_ReadsManifestOnce) {
    const TemporaryFolder folder;
    const std::string mine = (folder.path() / "mine").string();
    writeFile(folder / "mine/technique.toml",
              "title = 'Mine'\ncitation = 'me'\ninputs = ['height']\nlimits = []\nneeds = []\n");
    writeFile(folder / "mine/mine.glsl", "ReliefHit traceRelief(ReliefRay ray) { return missed(); }\n");
    ManifestCache manifests;
    EXPECT_EQ(&manifests.surface("flat"), &manifests.surface("flat"));
    const Manifest& read = manifests.search(mine);
    std::filesystem::remove_all(mine);
    EXPECT_EQ(&manifests.search(mine), &read);
    EXPECT_NO_THROW(composeTechnique(parseTechnique(mine), manifests));
}

} // namespace
} // namespace plumbline
