// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/toml_document.h"

#include <gtest/gtest.h>

#include "app/case/render_toml.h"
#include "tests/app/case/case_text.h"

namespace etendue {
namespace {

std::string fault_of(const std::string& text) {
  try {
    parse_toml(text, "slab.toml");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(TomlDocument, RemembersTheLineAndKeyOfEveryValue) {
  const TomlNode root =
      parse_toml("a = 1\n[b.\"c d\"]\ne = [\n  2,\n  3]\n[[f]]\n[[f]]\ng = 4\n", "slab.toml");
  EXPECT_EQ(root.find("a")->origin.line, 1);
  const TomlNode& table = *root.find("b")->find("c d");
  EXPECT_EQ(table.origin.line, 2);
  EXPECT_EQ(table.find("e")->array()[1]->origin.line, 5);
  EXPECT_EQ(table.find("e")->array()[1]->origin.key, "b.\"c d\".e[1]");
  EXPECT_EQ(root.find("f")->array()[1]->find("g")->origin.line, 8);
  EXPECT_EQ(root.find("f")->array()[1]->find("g")->origin.key, "f[1].g");
}

TEST(TomlDocument, CountsLinesEndedByCarriageReturns) {
  EXPECT_EQ(parse_toml("a = 1\r\nb = 2\r\n", "slab.toml").find("b")->origin.line, 2);
}

TEST(TomlDocument, SkipsAByteOrderMark) {
  EXPECT_EQ(parse_toml("\xEF\xBB\xBF"
                       "a = 1\n",
                       "slab.toml")
                .find("a")
                ->number(),
            1);
}

TEST(TomlDocument, NamesTheLineOfANulByte) {
  EXPECT_EQ(fault_of(std::string("a = 1\nb = \0\n", 13)),
            "slab.toml:2: a NUL byte (the file is not text in UTF-8); a case is a TOML file");
}

struct Broken {
  const char* name;
  std::string text;
  const char* beginning;
};

class BrokenToml : public testing::TestWithParam<Broken> {};

TEST_P(BrokenToml, IsReportedWithItsLine) {
  const std::string fault = fault_of(GetParam().text);
  EXPECT_TRUE(fault.starts_with(GetParam().beginning)) << fault;
  EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
}

INSTANTIATE_TEST_SUITE_P(
    Each, BrokenToml,
    testing::Values(Broken{"Truncated", "a = 1\nb = [1, 2", "slab.toml:2: not TOML: "},
                    Broken{"TruncatedText", "a = 1\nb = \"smo", "slab.toml:2: not TOML: "},
                    Broken{"TruncatedTable", "a = 1\n[mesh", "slab.toml:2: not TOML: "},
                    Broken{"DuplicateKey", "a = 1\nb = 2\na = 3\n", "slab.toml:3: not TOML: "},
                    Broken{"DuplicateTable", "[a]\n[b]\n[a]\n", "slab.toml:3: not TOML: "},
                    Broken{"HugeInteger", "a = 1\nb = 99999999999999999999\n", "slab.toml:2: not TOML: "},
                    Broken{"InvalidUtf8", "a = 1\nb = \"\xff\xfe\"\n", "slab.toml:2: not TOML: "},
                    Broken{"Utf16", std::string("\xff\xfe\x61\0\x3d\0\x31\0", 8), "slab.toml:1: a NUL byte"},
                    Broken{"ControlCharacter", "a = 1\nb\x01 = 2\n", "slab.toml:2: not TOML: "},
                    Broken{"NumberWithUnit", "a = 1\nb = 3 cm\n", "slab.toml:2: not TOML: "},
                    Broken{"DeepNesting", "a = " + std::string(100000, '['), "slab.toml:1: not TOML: "}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(TomlDocument, IsCutAnywhereWithoutACrash) {
  const std::string whole =
      cube + "[media.smoke]\nphase = [{ model = \"isotropic\" }] # a comment\nd = 1979-05-27\n";
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string cut = whole.substr(0, length);
    const std::string fault = fault_of(cut);
    EXPECT_TRUE(fault.empty() || fault.starts_with("slab.toml:")) << cut << "\n" << fault;
  }
}

TEST(TomlDocument, RefusesFilesThatCannotBeRead) {
  const TestFolder folder;
  try {
    read_toml(folder.path() / "none.toml");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()),
              (folder.path() / "none.toml").string() + ": cannot be opened (No such file or directory)");
  }
  try {
    read_toml(folder.path());
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()),
              folder.path().string() + ": is a directory; give the case file in it");
  }
}

TEST(TomlValue, IsReadWithTheGivenOrigin) {
  const auto value = parse_toml_value("[1, 2.5]", {"--set", 0, "mesh.box[0].min"});
  ASSERT_TRUE(value);
  EXPECT_EQ(value->array()[1]->number(), 2.5);
  EXPECT_EQ(value->array()[1]->origin.line, 0);
  EXPECT_EQ(value->array()[1]->origin.key, "mesh.box[0].min[1]");
}

TEST(TomlValue, IsEmptyForOtherText) {
  EXPECT_FALSE(parse_toml_value("product", {}));
  EXPECT_FALSE(parse_toml_value("", {}));
  EXPECT_FALSE(parse_toml_value("1\nb = 2", {}));
}

TEST(TomlText, ReadsBackTheSame) {
  const std::string text = R"(a = "quoted \" \\ \n \u0001 é"
b = 0.1
c = 1e+60
d = 1.0
e = nan
"f g" = 1979-05-27

[table]
x = [1, [2, 3]]

[[list]]
n = 1

[[other]]

[[list]]
n = 2
inline = { k = true }
)";
  const std::string once = render_toml(parse_toml(text, ""));
  EXPECT_EQ(render_toml(parse_toml(once, "")), once);
  EXPECT_LT(once.find("n = 1"), once.find("[[other]]"));
  EXPECT_LT(once.find("[[other]]"), once.find("n = 2"));
}

}  // namespace
}  // namespace etendue
