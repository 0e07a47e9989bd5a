// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace etendue {

/// What a key takes.
enum class KeyType {
  any,               ///< not looked into
  text,              ///< "…"
  number,            ///< integer or float
  integer,           ///< without a decimal point
  boolean,           ///< true or false
  switch_,           ///< "auto", true or false
  point,             ///< [x, y, z]
  points,            ///< list of points
  texts,             ///< list of text
  numbers,           ///< list of numbers
  band_texts,        ///< text, or a list with one for each band
  band_numbers,      ///< a number, or a list with one for each band
  band_values,       ///< a number, a formula in x, y, z or a field from a file, or a list of such
  place_value,       ///< a number, a formula in x, y, z or a field from a file; the same in all bands
  thermal_value,     ///< as place_value, but formulas may use the temperature T too
  size_bound,        ///< a number, or a table NAME = number
  named_integers,    ///< a table NAME = integer
  named_points,      ///< a table NAME = [x, y, z]
  choice_or_number,  ///< one of the choices, or a number
  rotation,          ///< "random", or a table of `axis` and `angle`
  named_sides        ///< a table of xmin … zmax = text
};

/// Numbers that a key accepts.
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool lowest_excluded = false;
  bool highest_excluded = false;

  bool holds(double number) const;
  /// "at least 0", "above 0", "from 0 to 1", …; empty where every number will do.
  std::string text() const;
};

/// The version that no longer knows former names of keys.
inline constexpr std::string_view former_names_until = "0.2";

enum class Need { optional, required };

/// What is said of a key besides its type.
struct KeyDetails {
  std::string_view unit = "";
  std::string default_value = "";      ///< as TOML; empty: none
  std::string_view default_note = "";  ///< where the default is not a fixed value
  Range range = {};
  std::vector<std::string> choices = {};  ///< of text or integers; empty: any
  std::vector<std::string> later = {};    ///< documented choices that this version does not have
  std::string_view former_name = "";      ///< deprecated, but accepted; empty: none
  Need need = Need::optional;
};

/// A key of the case file. `table` is its place: names that the user chooses are written NAME.
struct KeyDeclaration : KeyDetails {
  KeyDeclaration(std::string_view in_table, std::string_view key, KeyType key_type, KeyDetails details,
                 std::string_view meaning)
      : KeyDetails(std::move(details)), table(in_table), name(key), type(key_type), help(meaning) {}

  std::string_view table;
  std::string_view name;
  KeyType type;
  std::string_view help;
};

/// How a table is written: `[name]`, `[[name]]`, or an inline table or a list of them.
enum class TableForm { table, list, table_or_list };

struct TableDeclaration {
  std::string_view path;
  TableForm form = TableForm::table;
  std::string_view help = "";
};

/// The table of a value that is read from a file, in the place of a number or formula.
inline constexpr std::string_view field_table = "media.NAME.COEFFICIENT";

/// All keys, in the order of the reference page.
std::span<const KeyDeclaration> key_declarations();
std::span<const TableDeclaration> table_declarations();

/// Null where there is none. A NAME in `table` stands for any name.
const KeyDeclaration* find_key(std::string_view table, std::string_view name);
const TableDeclaration* find_table(std::string_view path);

/// Names of the keys and tables that may be in a table; without NAME.
std::vector<std::string> names_in(std::string_view table);
/// `[table]` or `[[table]]`.
std::string table_header(std::string_view path);

/// "number", "[x, y, z]", …, as the reference page has it.
std::string_view type_column(KeyType type);

/// "a number above 0", "\"auto\" or \"none\"", …
std::string accepted_text(const KeyDeclaration& key);

/// "Formerly `gather`, which is accepted until 0.2."; empty without a former name.
std::string former_name_text(const KeyDeclaration& key);

/// The reference page of all keys, in Markdown.
std::string key_reference();

}  // namespace etendue
