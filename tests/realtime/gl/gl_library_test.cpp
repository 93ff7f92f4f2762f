// Missing or wrong libraries of the GL stack.
#include "realtime/gl/gl_library.h"
#include "tests/errors.h"

#include <array>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

TEST(GlLibrary, MissingLibrary_ErrorNamesPackage) {
    const auto open = [] { GlLibrary("egl", std::array{"libNone.so.1", "libNone.so.2"}, "install none"); };
    EXPECT_THAT(
        messageOf<MachineError>(open),
        AllOf(StartsWith("egl: libNone.so.1: "), HasSubstr("libNone.so.2: "), EndsWith("; install none")));
}

TEST(GlLibrary, FirstAvailable_IsOpened) {
    const GlLibrary library("egl", std::array{"libNone.so.1", "libm.so.6"}, "");
    double (*cosine)(double) = nullptr;
    library.find("cos", cosine);
    ASSERT_NE(cosine, nullptr);
    EXPECT_EQ(cosine(0), 1);
    void (*none)() = nullptr;
    EXPECT_EQ(messageOf<MachineError>([&] { library.find("eglNone", none); }),
              "egl: libm.so.6 has no eglNone");
}

} // namespace
} // namespace plumbline
