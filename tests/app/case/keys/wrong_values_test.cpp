// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A value of a wrong type in every key that is declared, alone in its table and beside sound values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/case/keys/keys.h"
#include "base/errors.h"
#include "tests/app/case/case_text.h"

namespace etendue::wrong_values_test {
namespace {

/// No key takes a date.
const std::string wrong = "1979-05-27";

/// The names "NAME" of a region or wall, and of a coefficient, in a path as some that exist.
std::string with_names(std::string path) {
  if (path == field_table) path = "media.NAME.absorption";
  for (std::size_t at = path.find("NAME"); at != std::string::npos; at = path.find("NAME"))
    path.replace(at, 4, "air");
  return path;
}

/// The headers of a table and of the lists that it is in.
std::string headers(std::string_view table) {
  if (table.empty()) return "";
  std::string text;
  for (std::size_t end = table.find('.');; end = table.find('.', end + 1)) {
    const std::string_view path = table.substr(0, end);
    const TableDeclaration* declared = find_table(path);
    const bool is_list = declared != nullptr && declared->form != TableForm::table;
    if (is_list)
      text += "[[" + with_names(std::string(path)) + "]]\n";
    else if (end == std::string_view::npos)
      text += "[" + with_names(std::string(path)) + "]\n";
    if (end == std::string_view::npos) return text;
  }
}

std::string sound_number(const KeyDeclaration& key) {
  if (std::isfinite(key.range.lowest) && std::isfinite(key.range.highest))
    return std::to_string((key.range.lowest + key.range.highest) / 2);
  return std::to_string(std::isfinite(key.range.lowest) ? key.range.lowest + 1 : 0.5);
}

/// A value of the right type; empty for texts that name files and other things that do not exist.
std::string sound_value(const KeyDeclaration& key) {
  if (!key.default_value.empty()) return std::string(key.default_value);
  switch (key.type) {
    case KeyType::text:
    case KeyType::band_texts:
      if (!key.choices.empty()) return "\"" + key.choices.front() + "\"";
      return key.need == Need::required ? "\"x\"" : "";
    case KeyType::integer:
      return std::to_string(std::lround(std::stod(sound_number(key))));
    case KeyType::number:
    case KeyType::band_numbers:
    case KeyType::band_values:
    case KeyType::size_bound:
      return sound_number(key);
    case KeyType::boolean:
    case KeyType::switch_:
      return "true";
    case KeyType::point:
      return "[0.1, 0.2, 0.3]";
    case KeyType::points:
      return "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]";
    case KeyType::texts:
      return "[\"x\"]";
    case KeyType::numbers:
      return "[1, 2]";
    default:
      return "";
  }
}

/// The other keys of a table, with sound values; the key number `chosen` has its choice number `choice`.
std::string other_keys(const KeyDeclaration& key, std::size_t chosen, std::size_t choice) {
  std::string text;
  const auto keys = key_declarations();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].table != key.table || keys[i].name == key.name) continue;
    std::string value = sound_value(keys[i]);
    if (i == chosen)
      value =
          keys[i].type == KeyType::integer ? keys[i].choices[choice] : "\"" + keys[i].choices[choice] + "\"";
    if (!value.empty()) text += std::string(keys[i].name) + " = " + value + "\n";
  }
  return text;
}

std::string faulty_key(const KeyDeclaration& key) { return std::string(key.name) + " = " + wrong + "\n"; }

TEST(WrongValues, AloneInTheirTableAreInputErrors) {
  for (const KeyDeclaration& key : key_declarations()) {
    if (key.type == KeyType::any) continue;
    const std::string text = headers(key.table) + faulty_key(key), faults = faults_of(text);
    EXPECT_NE(faults.find(std::string(key.name) + " = " + wrong), std::string::npos) << text << faults;
  }
}

TEST(WrongValues, BesideSoundValuesAreInputErrors) {
  const auto keys = key_declarations();
  for (const KeyDeclaration& key : keys) {
    if (key.type == KeyType::any) continue;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      // Readers go by the choices of a table, such as the kind of a light.
      const bool decides = keys[i].table == key.table && keys[i].name != key.name &&
                           !keys[i].choices.empty() && keys[i].type != KeyType::texts;
      for (std::size_t choice = 0; decides && choice < keys[i].choices.size(); ++choice) {
        const std::string text = headers(key.table) + faulty_key(key) + other_keys(key, i, choice);
        std::string faults;
        try {
          faults = faults_of(text);
        } catch (const FileError&) {
          continue;
        }
        EXPECT_NE(faults.find(std::string(key.name) + " = " + wrong), std::string::npos) << text << faults;
      }
    }
  }
}

TEST(WrongValues, OfALightAndASensorAreNamed) {
  EXPECT_EQ(
      faults_of(cube + "[[light]]\nname = \"sun\"\nkind = \"sun\"\ndirection = [0, 0, -1]\nirradiance = 1\n"
                       "walls = \"zmax\"\n"),
      "slab.toml:12: light[0].walls = \"zmax\": must not be text; use a list of text");
  EXPECT_EQ(faults_of(cube + "[[sensor]]\nname = \"s\"\nkind = \"cone\"\nposition = [0, 0, 0]\n"
                             "direction = [1, 0, 0]\nangle = -1\n"),
            "slab.toml:12: sensor[0].angle = -1: out of range; use a number above 0 and at most 90");
}

}  // namespace
}  // namespace etendue::wrong_values_test
