// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/keys.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/case/keys/key_help.h"
#include "app/case/keys/key_schema.h"
#include "app/case/keys/value_check.h"
#include "app/case/toml/toml_document.h"
#include "base/errors.h"
#include "tests/support/checkout.h"

namespace etendue::keys_test {
namespace {

TEST(Keys, AreDeclaredOnce) {
  std::set<std::pair<std::string_view, std::string_view>> seen;
  for (const KeyDeclaration& key : key_declarations())
    EXPECT_TRUE(seen.insert({key.table, key.name}).second) << key.table << "." << key.name;
}

TEST(Keys, StandInDeclaredTables) {
  for (const KeyDeclaration& key : key_declarations())
    EXPECT_NE(find_table(key.table), nullptr) << key.table << "." << key.name;
}

TEST(Keys, HaveHelp) {
  for (const KeyDeclaration& key : key_declarations()) EXPECT_FALSE(key.help.empty()) << key.name;
  for (const TableDeclaration& table : table_declarations()) EXPECT_FALSE(table.help.empty()) << table.path;
}

TEST(Keys, HaveDefaultsThatTheyAccept) {
  for (const KeyDeclaration& key : key_declarations()) {
    if (key.default_value.empty()) continue;
    auto value = parse_toml_value(key.default_value, {"", 0, std::string(key.name)});
    ASSERT_TRUE(value) << key.name;
    Faults faults;
    check_value(*value, key, faults);
    EXPECT_TRUE(faults.empty()) << faults.front().text;
  }
}

TEST(Range, SaysWhatItHolds) {
  const Range open{.lowest = -1, .highest = 1, .lowest_excluded = true, .highest_excluded = true};
  EXPECT_TRUE(open.holds(0.999));
  EXPECT_FALSE(open.holds(1));
  EXPECT_FALSE(open.holds(-1));
  EXPECT_EQ(open.text(), "above -1 and below 1");
  EXPECT_EQ((Range{.lowest = 0, .highest = 1}.text()), "from 0 to 1");
  EXPECT_EQ(Range{.lowest = 0}.text(), "at least 0");
  EXPECT_EQ(Range{}.text(), "");
}

// Renew it with: etendue keys > docs/user/keys.md
TEST(KeyReference, IsTheCommittedPage) {
  std::ifstream page(test::checkout("docs/user/keys.md"));
  const std::string committed((std::istreambuf_iterator<char>(page)), std::istreambuf_iterator<char>());
  EXPECT_TRUE(key_reference() == committed);
}

// scripts/check_schema holds it to the cases and to faulty ones.
TEST(KeySchema, HasEveryKeyWithItsMeaning) {
  const auto schema = nlohmann::json::parse(key_schema());
  std::size_t described = 0;
  const std::function<void(const nlohmann::json&)> count = [&](const nlohmann::json& node) {
    if (node.is_object() && node.contains("properties"))
      for (const auto& [name, property] : node["properties"].items())
        if (property.contains("description")) ++described;
    for (const auto& child : node)
      if (child.is_structured()) count(child);
  };
  count(schema);
  EXPECT_GE(described, key_declarations().size());
  const auto& wall = schema["properties"]["walls"]["additionalProperties"];
  EXPECT_EQ(wall["additionalProperties"], false);
  const auto& diffuse = wall["properties"]["diffuse"];
  EXPECT_EQ(diffuse["anyOf"][0]["maximum"], 1.0);
  EXPECT_EQ(diffuse["default"], 0.0);
  EXPECT_EQ(schema["properties"]["mesh"]["properties"]["box"]["items"]["required"],
            nlohmann::json({"min", "max"}));
}

TEST(Keys, NameTheirFormerNames) {
  const auto camera = nlohmann::json::parse(key_schema())["properties"]["camera"]["items"]["properties"];
  EXPECT_EQ(camera["gather"]["deprecated"], true);
  EXPECT_EQ(camera["gather"]["enum"], camera["gather_rays"]["enum"]);
  EXPECT_FALSE(camera["gather_rays"].contains("deprecated"));
  EXPECT_NE(key_help("mesh.split").find("Formerly `split`, which is accepted until 0.2."), std::string::npos);
  EXPECT_EQ(key_help("mesh.split"), key_help("mesh.refine"));
}

TEST(KeyHelp, DescribesATableAndAKey) {
  const std::string box = key_help("mesh.box");
  EXPECT_EQ(box.rfind("[[mesh.box]]\n", 0), 0U);
  EXPECT_NE(box.find("\n  region\n"), std::string::npos);
  EXPECT_EQ(key_help("[[mesh.box]]"), box);
  const std::string diffuse = key_help("walls.floor.diffuse");
  EXPECT_NE(diffuse.find("from 0 to 1; default: 0.0"), std::string::npos);
  EXPECT_EQ(key_help("diffuse"), diffuse);
  EXPECT_NE(key_help("title").find("What the case is called."), std::string::npos);
}

TEST(KeyHelp, FitsATerminal) {
  for (const TableDeclaration& table : table_declarations()) {
    if (table.path.empty()) continue;
    std::istringstream lines(key_help(table.path));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  }
}

TEST(KeyHelp, NamesWhatIsMeant) {
  try {
    key_help("solve.tolerence");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"solve.tolerance\"?"), std::string::npos);
  }
}

}  // namespace
}  // namespace etendue::keys_test
