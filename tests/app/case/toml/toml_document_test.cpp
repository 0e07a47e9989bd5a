// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/toml/toml_document.h"

#include <gtest/gtest.h>

#include "app/case/toml/render_toml.h"
#include "tests/app/case/case_text.h"

namespace etendue::toml_document_test {
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

TEST_P(BrokenToml, IsReportedWithItsPlaceAndARemedy) {
  const std::string fault = fault_of(GetParam().text);
  EXPECT_TRUE(fault.starts_with(GetParam().beginning)) << fault;
  EXPECT_LT(fault.size(), 500U) << "long lines are cut";
}

INSTANTIATE_TEST_SUITE_P(
    Each, BrokenToml,
    testing::Values(
        Broken{"TextWithoutQuotes", "[medium]\nname = smoke\n",
               "slab.toml:2:8: text needs quotes; write \"smoke\"\n    name = smoke\n           ^"},
        Broken{"TextLikeABoolean", "wall = floor # south\n",
               "slab.toml:1:8: text needs quotes; write \"floor\""},
        Broken{"TextLikeNotANumber", "wall = none\n", "slab.toml:1:8: text needs quotes; write \"none\""},
        Broken{"NoEqualsSign", "[mesh]\nmax_volume 0.1\n",
               "slab.toml:2:12: = is missing between a key and its value; write max_volume = 0.1\n    "
               "max_volume 0.1\n               ^"},
        Broken{"Colon", "a : 3\n", "slab.toml:1:3: a key and its value are separated by =, not by :"},
        Broken{"TwoEqualsSigns", "a == 3\n", "slab.toml:1:4: one = too many; write key = value"},
        Broken{"NoValue", "a =\nb = 1\n", "slab.toml:1:4: a value is missing here; write key = value"},
        Broken{"KeyAlone", "a = 1\nmesh\n",
               "slab.toml:2:5: a key without a value; write mesh = value, or [mesh] for a table"},
        Broken{"KeyWithSpace", "max volume = 1\n",
               "slab.toml:1:5: a key has no spaces or other signs; write max_volume or \"max volume\""},
        Broken{"KeyWithUmlaut", "gr\u00f6\u00dfe = 1\n",
               "slab.toml:1:3: a key with other signs than a to z, digits, - and _ needs quotes; write "
               "\"gr\u00f6\u00dfe\""},
        Broken{"TextNotClosed", "a = 1\nb = [\"x\", \"smo]\nc = 2\n",
               "slab.toml:2:11: the text that begins here is not closed; \" is missing at its end\n    b = "
               "[\"x\", \"smo]\n              ^"},
        Broken{"TextNotClosedWithCarriageReturn", "a = \"smo\r\nb = 1\r\n",
               "slab.toml:1:5: the text that begins here is not closed; \" is missing at its end\n    a = "
               "\"smo\n        ^"},
        Broken{"TextCutShort", "a = 1\nb = \"smo",
               "slab.toml:2:5: the text that begins here is not closed; \" is missing at its end"},
        Broken{"LongTextNotClosed", "a = \"\"\"x\nb = 1\n",
               "slab.toml:1:5: the text that begins here is not closed; \"\"\" is missing"},
        Broken{"ListNotClosed", "a = [1, [2, 3],\n  4\nb = 3\n",
               "slab.toml:1:5: the list that begins here is not closed; ] is missing before line 3"},
        Broken{"ListNotClosedBeforeTable", "a = [1\n[mesh]\nb = 3\n",
               "slab.toml:1:5: the list that begins here is not closed; ] is missing before line 2"},
        Broken{"ListCutShort", "a = 1\nb = [1, 2",
               "slab.toml:2:5: the list that begins here is not closed; ] is missing"},
        Broken{"TableNotClosed", "a = 1\n[mesh", "slab.toml:2:6: ] is missing behind the name of the table"},
        Broken{"TableHalfClosed", "[[box]\nmin = [0, 0, 0]\n",
               "slab.toml:1:7: ]] is missing behind the name of the table"},
        Broken{"KeyBehindTable", "[mesh] max_volume = 1\n",
               "slab.toml:1:8: the line of a table ends with its name; begin a new line for the first key"},
        Broken{"DuplicateTable", "[mesh]\na = 1\n[b]\n[mesh]\n",
               "slab.toml:4:1: the table mesh is on line 1 already; put all its keys in one place"},
        Broken{"TableAndList", "[[probe]]\na = 1\n[probe]\n",
               "slab.toml:3:1: probe is a list of tables since line 1; write [[probe]] for each of them"},
        Broken{"ListAndTable", "[probe]\na = 1\n[[probe]]\n",
               "slab.toml:3:1: [probe] on line 1 is a single table; write [[probe]] there too for one of "
               "several"},
        Broken{"DuplicateKey", "a = 0\n[mesh]\na = 1\nb = 2\na = 3\n",
               "slab.toml:5:1: a has a value on line 3 already; remove one of them\n    a = 3\n    ^"},
        Broken{"DuplicateKeyOfAListOfTables", "[[box]]\na = 1\n[[box]]\na = 1\na = 3\n",
               "slab.toml:5:1: a has a value on line 4 already; remove one of them"},
        Broken{"ValueAndTable", "a = 1\na.b = 2\n",
               "slab.toml:2:1: a has a value on line 1, and cannot be a table too"},
        Broken{"TableWithinAValue", "a = 1\n[a.b] # c\n\nc = 2\n",
               "slab.toml:2:1: a on line 1 is a value, and cannot be a table too\n    [a.b] # c\n    ^"},
        Broken{"TableWithinAValueAtTheEnd", "a = 1\n[[a.b]]",
               "slab.toml:2:1: a on line 1 is a value, and cannot be a table too"},
        Broken{"BracesOverLines", "a = { x = 1,\n  y = 2 }\n",
               "slab.toml:1:5: what is in { } must end on its line; write all of it there, or as a table of "
               "its own"},
        Broken{"CommaBeforeBrace", "a = { x = 1, }\n",
               "slab.toml:1:14: a comma too many before }; remove it"},
        Broken{"CommaMissingInList", "a = [1 2]\n",
               "slab.toml:1:8: a comma is missing between two values of a list"},
        Broken{"CommaMissingInLongList", "a = [\n  [1, 2, 3]\n  [4, 5, 6]\n]\n",
               "slab.toml:3:3: a comma is missing between two values of a list"},
        Broken{"CommaMissingInBraces", "a = { x = 1 y = 2 }\n",
               "slab.toml:1:13: a comma is missing between two entries in { }"},
        Broken{"True", "a = True\n", "slab.toml:1:5: True is written in small letters; write true"},
        Broken{"Yes", "a = yes\n", "slab.toml:1:5: yes is no value; write true, or \"yes\" for text"},
        Broken{"DecimalComma", "[mesh]\na = 0,5\n",
               "slab.toml:2:6: decimals are separated by a point; write 0.5\n    a = 0,5\n         ^"},
        Broken{"Thousands", "a = 1,234.5\n", "slab.toml:1:6: thousands are not separated; write 1234.5"},
        Broken{"ListWithoutBrackets", "a = 1, 2, 3\n",
               "slab.toml:1:6: several values are a list in brackets; write [1, 2, 3]"},
        Broken{"ListInParentheses", "a = (1, 2)\n",
               "slab.toml:1:5: a list is written in square brackets: [1, 2, 3]"},
        Broken{"NoDigitBeforePoint", "a = -.5\n",
               "slab.toml:1:6: a digit is missing before the point; write -0.5"},
        Broken{"NoDigitAfterPoint", "a = [5., 1]\n",
               "slab.toml:1:8: a digit is missing after the point; write 5.0"},
        Broken{"ZeroInFront", "a = 007\n", "slab.toml:1:8: a number has no zeros in front; write 7"},
        Broken{"NumberWithUnit", "a = 1\nb = 3 cm\n",
               "slab.toml:2:7: a number has no unit behind it; write 3 in the units of [units], or \"3 cm\" "
               "for text"},
        Broken{"Calculation", "a = 1/3\n",
               "slab.toml:1:6: a value is a number, not a calculation; write its result"},
        Broken{
            "HugeInteger", "a = 1\nb = 99999999999999999999\n",
            "slab.toml:2:25: a whole number beyond 64 bits; write it with a point: 99999999999999999999.0"},
        Broken{"SlashComment", "// a lamp\na = 1\n", "slab.toml:1:1: a comment begins with #"},
        Broken{"SlashCommentBehindValue", "\ta = 1 // a lamp\n",
               "slab.toml:1:8: a comment begins with #\n    \ta = 1 // a lamp\n    \t      ^"},
        Broken{"Backslash", "a = \"C:\\Users\"\n",
               "slab.toml:1:10: \\ in \"...\" begins a special sign; write paths with / or in single quotes"},
        Broken{"TypographicQuotes", "a = \u201csmoke\u201d\n",
               "slab.toml:1:5: \u201c is no quote of TOML; text is written \"like this\""},
        Broken{"TypographicMinus", "a = \u22121\n",
               "slab.toml:1:5: \u2212 is no minus sign of TOML; write - as on the keyboard"},
        Broken{"SpecialSpace", "a = 1\u00a0\n",
               "slab.toml:1:6: a special space that only looks like one; delete it and type a space"},
        Broken{"BehindAByteOrderMark",
               "\xEF\xBB\xBF"
               "a = smoke\n",
               "slab.toml:1:5: text needs quotes; write \"smoke\""},
        Broken{"Latin1", "a = 1\nb = \"M\xfcnchen\"\n",
               "slab.toml:2:7: not UTF-8 (Latin-1 or another encoding?); save the file as UTF-8\n    b = "
               "\"M?nchen\"\n          ^"},
        Broken{"InvalidUtf8", "a = 1\nb = \"\xff\xfe\"\n", "slab.toml:2:6: not UTF-8"},
        Broken{"Utf16", std::string("\xff\xfe\x61\0\x3d\0\x31\0", 8), "slab.toml:1: a NUL byte"},
        Broken{"ControlCharacter", "a = 1\nb\x01 = 2\n",
               "slab.toml:2:2: a key has no spaces or other signs; write b_ or \"b?\""},
        Broken{"DeepNesting", "a = " + std::string(100000, '['),
               "slab.toml:1:261: brackets within brackets"}),
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
}  // namespace etendue::toml_document_test
