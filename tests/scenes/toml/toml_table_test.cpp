#include "scenes/toml/toml_table.h"
#include "tests/errors.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TomlTable parse(const std::string& text) {
    return TomlTable::parse("a.toml", text);
}

TEST(TomlTable, RequestedFields_AreRead) {
    const TomlTable root = parse("name = 'n'\nflag = true\ncount = 3\nsize = 2\nplace = [1, 2.5, -3]\n"
                                 "[camera]\nwidth = 8\n[[light]]\nname='a'\n[[light]]\nname='b'\n");
    EXPECT_EQ(root.text("name"), "n");
    EXPECT_TRUE(root.boolean("flag"));
    EXPECT_EQ(root.integer("count", 0, 9), 3);
    EXPECT_EQ(root.number("size", 0, 9), 2); // an integer is a valid number
    EXPECT_EQ(root.vector3("place", -9, 9), Vec3(1, 2.5, -3));
    EXPECT_EQ(root.table("camera").integer("width", 1, 9), 8);
    ASSERT_EQ(root.tables("light").size(), 2u);
    EXPECT_EQ(root.tables("light")[1].text("name"), "b");
    EXPECT_NO_THROW(root.finish());
}

TEST(TomlTable, ArraysAndInlineTables_AreRead) {
    const TomlTable root = parse("a = [3, 1, 2]\nb = []\nc = [1, 2.5]\nt = [{ x = 1 },\n{ x = 2, y = 3 }]\n");
    EXPECT_THAT(root.integers("a", 1, 3), ElementsAre(3, 1, 2));
    EXPECT_TRUE(root.integers("b", 1, 3).empty());
    EXPECT_EQ(inputErrorOf([&] { root.integers("c", 1, 3); }),
              "a.toml:3: c: is 2.5; expected a whole number from 1 to 3");
    EXPECT_EQ(inputErrorOf([&] { root.integers("d", 1, 3); }),
              "a.toml:1: d: is missing; expected an array of whole numbers");
    const std::vector<TomlTable> tables = root.tables("t");
    ASSERT_EQ(tables.size(), 2u);
    EXPECT_EQ(tables[1].integer("x", 0, 9), 2);
    EXPECT_EQ(inputErrorOf([&] { tables[1].finish(); }), "a.toml:5: t.y: unknown field; expected x");
}

TEST(TomlTable, Fallback_ReplacesOnlyMissingField) {
    const TomlTable root = parse("a = 1\n");
    EXPECT_EQ(root.integer("b", 0, 9, 5), 5);
    EXPECT_EQ(root.number("b", 0, 9, 0.5), 0.5);
    EXPECT_EQ(root.text("b", "x"), "x");
    EXPECT_EQ(root.choice("b", {"x", "y"}, "y"), "y");
    EXPECT_THAT(root.texts("b", std::vector<std::string>{"q"}), ElementsAre("q"));
    EXPECT_THROW(root.integer("a", 2, 9, 5), InputError); // present but invalid
    EXPECT_EQ(inputErrorOf([&] { root.integer("b", 0, 9); }),
              "a.toml:1: b: is missing; expected a whole number from 0 to 9");
}

TEST(TomlTable, WrongTypeOrRange_IsRefused) {
    const TomlTable root = parse("a = 1.5\nb = 'text'\nc = [1, 2]\nd = nan\ne = inf\nf = 2024-01-01\n"
                                 "g = 99999999999\nh = [1, 'x', 3]\n[t]\nu = -1\n");
    EXPECT_EQ(inputErrorOf([&] { root.integer("a", 0, 9); }),
              "a.toml:1: a: is 1.5; expected a whole number from 0 to 9");
    EXPECT_THAT(inputErrorOf([&] { root.number("b", 0, 9); }),
                HasSubstr("a.toml:2: b: is the string \"text\""));
    EXPECT_THAT(inputErrorOf([&] { root.vector3("c", 0, 9); }),
                HasSubstr("is an array of 2; expected an array of 3"));
    EXPECT_THAT(inputErrorOf([&] { root.number("d", 0, 9); }),
                HasSubstr("is nan; expected a number from 0 to 9"));
    EXPECT_THAT(inputErrorOf([&] { root.number("e", 0, 1e308); }), HasSubstr("is inf"));
    EXPECT_THAT(inputErrorOf([&] { root.text("f"); }), HasSubstr("is a date or time"));
    EXPECT_THAT(inputErrorOf([&] { root.integer("g", 0, 9); }), HasSubstr("is 99999999999"));
    EXPECT_THAT(inputErrorOf([&] { root.vector3("h", 0, 9); }), HasSubstr("is the string \"x\""));
    EXPECT_THAT(inputErrorOf([&] { root.table("a"); }), HasSubstr("is 1.5; expected a table"));
    EXPECT_THAT(inputErrorOf([&] { root.tables("t"); }), HasSubstr("is a table; expected tables [[t]]"));
    EXPECT_THAT(inputErrorOf([&] { root.table("t").number("u", 0, 9); }), HasSubstr("a.toml:10: t.u: is -1"));
    EXPECT_THAT(inputErrorOf([&] { root.boolean("a"); }), HasSubstr("true or false"));
}

TEST(TomlTable, UnknownField_IsRefusedWithHint) {
    const TomlTable root = parse("widht = 3\n");
    root.integer("width", 0, 9, 1);
    root.integer("height", 0, 9, 1);
    EXPECT_EQ(inputErrorOf([&] { root.finish(); }),
              "a.toml:1: widht: unknown field; expected height or width; did you mean 'width'?");
}

TEST(TomlTable, MultilineText_IsRefused) {
    const TomlTable root = parse("a = 'one'\nb = ''\nc = \"x\\ny\"\nd = 3\n");
    EXPECT_EQ(root.line("a"), "one");
    EXPECT_EQ(inputErrorOf([&] { root.line("b"); }), "a.toml:2: b: is empty; expected a single-line string");
    EXPECT_EQ(inputErrorOf([&] { root.line("c"); }),
              "a.toml:3: c: has a control character; expected a single-line string");
    EXPECT_EQ(inputErrorOf([&] { root.line("d"); }), "a.toml:4: d: is 3; expected a string in quotes");
    EXPECT_EQ(inputErrorOf([&] { root.line("e"); }),
              "a.toml:1: e: is missing; expected a single-line string");
}

TEST(TomlTable, FaultyElement_NamesItsLine) {
    TomlTable root = parse("a = [\n  'x',\n  'y',\n]\nb = ['x',\n'x']\nc = ['x',\n'']\nd = ['x',\n3]\n");
    const std::vector<std::string> known{"x", "yes"};
    EXPECT_THAT(root.distinctTexts("a"), ElementsAre("x", "y"));
    EXPECT_THAT(root.someOf("q", known, std::vector<std::string>{"z"}), ElementsAre("z"));
    EXPECT_EQ(inputErrorOf([&] { root.someOf("a", known); }),
              "a.toml:3: a: holds the string \"y\"; expected x or yes");
    EXPECT_EQ(inputErrorOf([&] { root.someOf("b", known); }),
              "a.toml:6: b: holds \"x\" twice; expected each once");
    EXPECT_EQ(inputErrorOf([&] { root.distinctTexts("c"); }),
              "a.toml:8: c: holds an empty string; expected strings");
    EXPECT_EQ(inputErrorOf([&] { root.texts("d"); }), "a.toml:10: d: holds 3; expected strings");
    EXPECT_EQ(inputErrorOf([&] { root.someOf("e", known); }),
              "a.toml:1: e: is missing; expected an array with some of x or yes");
    root.change("--scene-set", "b", "['y']");
    EXPECT_EQ(inputErrorOf([&] { root.someOf("b", known); }),
              "--scene-set: holds the string \"y\"; expected x or yes");
}

TEST(TomlTable, UnknownChoice_HasHint) {
    EXPECT_EQ(inputErrorOf([] {
                  parse("\nwrap = 'repaet'").choice("wrap", {"repeat", "clamp"});
              }),
              "a.toml:2: wrap: is the string \"repaet\"; expected repeat or clamp; did you mean 'repeat'?");
}

TEST(TomlTable, SyntaxError_NamesItsLine) {
    EXPECT_THAT(inputErrorOf([] { parse("a = 1\nb = = 2\n"); }), HasSubstr("a.toml:2: is not valid TOML"));
    EXPECT_THAT(inputErrorOf([] { parse("a = 1\na = 2\n"); }), HasSubstr("a.toml:2"));
    EXPECT_THAT(inputErrorOf([] { parse("a = \"\xff\xfe\"\n"); }), HasSubstr("not valid TOML"));
    EXPECT_THAT(inputErrorOf([] { parse(std::string("a = \0", 5)); }), HasSubstr("not valid TOML"));
    EXPECT_THAT(inputErrorOf([] { parse("a = " + std::string(100000, '[')); }), HasSubstr("not valid TOML"));
}

TEST(TomlTable, DeepKeys_AreRefusedBeforeParsing) {
    const auto deep = [](int parts) {
        std::string key = "a";
        for (int i = 1; i < parts; ++i)
            key += ".a";
        return key;
    };
    EXPECT_TRUE(parse(deep(1000) + " = 1").has("a"));
    EXPECT_EQ(inputErrorOf([&] { parse(deep(100000) + " = 1"); }),
              "a.toml: has keys of more than 1000 parts within each other; expected a few");
    EXPECT_EQ(
        inputErrorOf([&] { parse("b = 1").change("--scene-set", "b", "{ " + deep(100000) + " = 1 }"); }),
        "--scene-set: has keys of more than 1000 parts within each other; expected a few");
    // Nested inline tables, also several in an array, quoted keys, and quotes and braces in strings.
    const auto nested = [&](int levels, const std::string& key, const std::string& before = "") {
        std::string text = "b = ";
        for (int i = 0; i < levels; ++i)
            text += before + "{ " + key + " = ";
        text += "1";
        for (int i = 0; i < levels; ++i)
            text += " }" + std::string(before.empty() ? "" : " ]");
        return text + "\n";
    };
    const std::string quoted = deep(90) + ".'/'.\"=\\\"{\"";
    EXPECT_TRUE(parse(nested(10, deep(90))).has("b"));
    EXPECT_TRUE(parse(nested(10, quoted)).has("b"));
    for (const std::string& text :
         {nested(12, deep(90)), nested(12, quoted), nested(12, deep(90), "[ { c = 2 }, "),
          "t = \"\"\"a \"quote\" }}\\\"\"\"\"\"\n# isn't {\n" + nested(12, deep(90)),
          "t = '''}'it''''\n" + nested(12, deep(90))})
        EXPECT_THAT(inputErrorOf([&] { parse(text); }), HasSubstr("parts within each other")) << text;
    EXPECT_TRUE(parse("t = \"" + std::string(2000, '.') + "\" # " + std::string(2000, '.') + "\n").has("t"));
}

} // namespace
} // namespace plumbline
