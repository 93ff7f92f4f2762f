#include "scenes/frame/frame.h"
#include "tests/errors.h"

#include <cmath>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

TEST(Frame, EveryChannelName_HasRow) {
    for (const char* name : {"R",
                             "G",
                             "B",
                             "A",
                             "Z",
                             "P.X",
                             "P.Y",
                             "P.Z",
                             "N.X",
                             "N.Y",
                             "N.Z",
                             "st.S",
                             "st.T",
                             "id",
                             "facing",
                             "fault",
                             "cost.fetches",
                             "cost.fetches.height",
                             "cost.fetches.baked",
                             "cost.iterations",
                             "curvature.a",
                             "curvature.b",
                             "curvature.cross",
                             "uncertain"})
        EXPECT_EQ(channelInfo(name).name, name);
    EXPECT_EQ(channelInfo("shadow.sun").name, "shadow.<light>");
    EXPECT_EQ(channelInfo("uncertain.shadow.sun").name, "uncertain.shadow.<light>");
    EXPECT_EQ(channelTable().size(), 26u); // 24 above and the two families
}

TEST(Frame, UnknownName_IsRefused) {
    EXPECT_NE(inputErrorOf([] { channelInfo("P.x"); }).find("did you mean 'P.X'?"), std::string::npos);
    EXPECT_THROW(channelInfo("shadow."), InputError); // a light without a name
    EXPECT_THROW(channelInfo("shadow"), InputError);
    EXPECT_THROW(channelInfo(""), InputError);
}

TEST(Frame, AddedChannel_HoldsMissValue) {
    Frame frame(3, 2);
    for (const float z : frame.add("Z"))
        EXPECT_EQ(z, kInfinityF);
    for (const float a : frame.add("A"))
        EXPECT_EQ(a, 0.0f);
    for (const float shadow : frame.add("shadow.sun"))
        EXPECT_TRUE(std::isnan(shadow));
    EXPECT_EQ(frame.channel("Z").size(), 6u);
    frame.channel("Z")[5] = 2;
    EXPECT_EQ(frame.add("Z")[5], kInfinityF); // adding again resets it
}

TEST(Frame, MissingChannel_ErrorListsChannels) {
    Frame frame(1, 1);
    frame.add("Z");
    frame.add("A");
    EXPECT_FALSE(frame.has("id"));
    EXPECT_NE(inputErrorOf([&] { frame.channel("id"); }).find("which are: A Z"), std::string::npos);
}

TEST(Frame, ShadowChannels_GiveLightNames) {
    Frame frame(1, 1);
    frame.add("shadow.sun");
    frame.add("shadow.lamp");
    frame.add("uncertain.shadow.moon");
    EXPECT_THAT(frame.lightNames(), testing::UnorderedElementsAre("sun", "lamp"));
}

/// The row of the README's channel table that names a channel.
std::string readmeRow(const std::string& channel) {
    std::ifstream readme(PLUMBLINE_SOURCE_DIR "/scenes/README.md");
    for (std::string line; std::getline(readme, line);)
        if (line.starts_with("| `") && line.find('`' + channel + '`') < line.find('|', 1)) return line;
    return {};
}

TEST(Frame, Readme_EqualsChannelTable) {
    for (const ChannelInfo& info : channelTable()) {
        const std::string row = readmeRow(std::string(info.name));
        ASSERT_NE(row, "") << info.name;
        const bool color = info.space == "linear"; // the table's 0 is written over with the background
        const std::string miss = color                        ? "background"
                                 : std::isnan(info.missValue) ? "NaN"
                                 : std::isinf(info.missValue) ? "+inf"
                                                              : "0";
        EXPECT_THAT(row, testing::HasSubstr("| " + miss + " |")) << info.name;
    }
}

} // namespace
} // namespace plumbline
