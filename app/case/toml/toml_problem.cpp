// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <regex>

#include "app/case/toml/toml_fault.h"
#include "base/text/trimmed.h"

namespace etendue {
namespace {

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

bool any_of(std::string_view text, std::initializer_list<std::string_view> values) {
  return std::ranges::find(values, text) != values.end();
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small;
}

bool matches_pattern(std::string_view text, const char* pattern) {
  return std::regex_match(text.begin(), text.end(), std::regex(pattern));
}

std::string without(std::string_view text, std::string_view characters) {
  std::string rest(text);
  std::erase_if(rest, [&](char c) { return has(characters, std::string_view(&c, 1)); });
  return rest;
}

std::string replaced(std::string_view text, const char* pattern, const char* by) {
  return std::regex_replace(std::string(text), std::regex(pattern), by);
}

/// Signs that text programs set in place of those of the keyboard; empty where there is none here.
std::string typographic_problem(std::string_view character) {
  if (any_of(character,
             {"\u201c", "\u201d", "\u201e", "\u2018", "\u2019", "\u201a", "\u00ab", "\u00bb", "`", "\u00b4"}))
    return fmt::format("{} is no quote of TOML; text is written \"like this\"", character);
  if (any_of(character, {"\u2212", "\u2013", "\u2014", "\u2010", "\u2011"}))
    return fmt::format("{} is no minus sign of TOML; write - as on the keyboard", character);
  if (any_of(character, {"\u00a0", "\u2009", "\u202f", "\u200b", "\u2003"}))
    return "a special space that only looks like one; delete it and type a space";
  return "";
}

bool is_letter(std::string_view character) {
  return character.size() == 1 && std::isalpha(static_cast<unsigned char>(character.front()));
}

/// Where the value that holds the place begins.
TomlPlace at_value(TomlPlace place) {
  const std::size_t begin = place.line.find_first_not_of(" \t", place.value);
  place.at = std::min(begin, place.at);
  return place;
}

/// A value that begins here is of no kind that TOML has.
std::string value_problem(const TomlPlace& place) {
  const std::string_view value = place.value_text();
  const std::string small = in_small_letters(value);
  if (const std::string found = typographic_problem(place.character()); !found.empty()) return found;
  if (any_of(small, {"true", "false", "nan", "inf", "+inf", "-inf"}))
    return fmt::format("{} is written in small letters; write {}", value, small);
  if (any_of(small, {"yes", "on"}))
    return fmt::format("{} is no value; write true, or \"{}\" for text", value, value);
  if (any_of(small, {"no", "off"}))
    return fmt::format("{} is no value; write false, or \"{}\" for text", value, value);
  if (value.starts_with('=')) return "one = too many; write key = value";
  if (value.starts_with('(')) return "a list is written in square brackets: [1, 2, 3]";
  if (matches_pattern(value, "[+-]{2,}.*")) return "a number has one sign at most";
  if (value.starts_with(',')) return "a comma too many; remove it";
  if (value.empty()) return "a value is missing here; write key = value";
  return fmt::format("text needs quotes; write \"{}\"", without(value, "\"'"));
}

/// A number that is written in a way that TOML does not know.
std::string number_problem(const TomlPlace& place, std::string_view description) {
  const std::string_view value = place.value_text();
  if (const std::string found = typographic_problem(place.character()); !found.empty()) return found;
  if (has(description, "representable"))
    return fmt::format("a whole number beyond 64 bits; write it with a point: {}.0", value);
  if (matches_pattern(value, "[+-]?0[0-9_]+([.][0-9]+)?"))
    return fmt::format("a number has no zeros in front; write {}",
                       replaced(value, "^([+-]?)0+(?=[0-9])", "$1"));
  if (matches_pattern(value, "[+-]?[.][0-9].*"))
    return fmt::format("a digit is missing before the point; write {}", replaced(value, "[.]", "0."));
  if (matches_pattern(value, "[+-]?[0-9]+[.]([eE].*)?"))
    return fmt::format("a digit is missing after the point; write {}", replaced(value, "[.]", ".0"));
  if (matches_pattern(value, "[0-9.+-]+[eE][+-]?"))
    return "the exponent has no digits; write 1e-3, for example";
  if (matches_pattern(value, "[0-9.eE+-]+ *%"))
    return fmt::format("% is no part of a number; write 0.1 for 10 %, for example");
  if (matches_pattern(value, ".*;"))
    return fmt::format("a line ends without ;; write {}", without(value, ";"));
  if (matches_pattern(value, ".*[0-9] *;.*")) return "each key has a line of its own; ; separates nothing";
  if (matches_pattern(value, "[0-9(][0-9.eE+() -]*[*/^].*"))
    return "a value is a number, not a calculation; write its result (keys that take a formula take it in "
           "quotes)";
  if (matches_pattern(value, "[+-]?[0-9.]+([eE][+-]?[0-9]+)? *[A-Za-z].*"))
    return fmt::format("a number has no unit behind it; write {} in the units of [units], or \"{}\" for text",
                       replaced(value, "^([+-]?[0-9.]+([eE][+-]?[0-9]+)?).*", "$1"), value);
  if (matches_pattern(value, "[0-9]+:.*")) return "a time has hours, minutes and seconds; text needs quotes";
  return fmt::format("{} is no number; write 12, 0.5 or 1e-3, and text in quotes", value);
}

/// Something follows a value, or the name of a table, on its line.
std::string surplus_problem(const TomlPlace& place, std::string_view description) {
  const std::string_view value = place.value_text(), rest = trimmed(place.rest()), here = place.character();
  if (const std::string found = typographic_problem(here); !found.empty()) return found;
  if (rest.starts_with("//") || rest.starts_with("--") || rest.starts_with("/*"))
    return "a comment begins with #";
  if (has(description, "table header")) {
    if (here == "]") return "a bracket too many; write [table], or [[table]] for each of several";
    return "the line of a table ends with its name; begin a new line for the first key";
  }
  if (matches_pattern(value, "[+-]?[0-9]+,[0-9]+([eE][+-]?[0-9]+)?"))
    return fmt::format("decimals are separated by a point; write {}", replaced(value, ",", "."));
  if (matches_pattern(value, "[+-]?[0-9]{1,3}(,[0-9]{3})+[.][0-9]*"))
    return fmt::format("thousands are not separated; write {}", without(value, ","));
  if (here == "," && rest == ",") return "a comma too many; a line ends without one";
  if (here == ",") return fmt::format("several values are a list in brackets; write [{}]", value);
  if (here == ";") return "a line ends without ;, and each key has a line of its own";
  if (here == "]" || here == "}")
    return fmt::format("{} closes nothing; remove it, or open what it ends", here);
  const std::string_view before = trimmed(place.line.substr(place.value, place.at - place.value));
  if (before.ends_with('"') && has(rest, "\""))
    return "a quote within text ends it; put such text in single quotes: 'say \"so\"'";
  if (matches_pattern(before, "[+-]?[0-9].*") && is_letter(here)) return number_problem(place, description);
  return "a key has one value; several are a list: [1, 2], text is in quotes";
}

/// The text before the = of a line is no key, or there is no =.
std::string key_problem(const TomlPlace& place) {
  const std::string_view here = place.character();
  const std::string key(trimmed(place.line.substr(0, place.at)));
  if (const std::string found = typographic_problem(here); !found.empty()) return found;
  if (here == ":") return "a key and its value are separated by =, not by :";
  if (place.at_end() || here == "#")
    return fmt::format("a key without a value; write {} = value, or [{}] for a table", key, key);
  if (here.size() > 1)
    return fmt::format("a key with other signs than a to z, digits, - and _ needs quotes; write \"{}\"",
                       trimmed(place.line.substr(place.value).substr(0, place.line.find('=') - place.value)));
  if (const std::size_t equals = place.rest().find('='); equals != std::string_view::npos) {
    const std::string whole(trimmed(place.line.substr(place.value, place.at + equals - place.value)));
    return fmt::format("a key has no spaces or other signs; write {} or \"{}\"",
                       replaced(whole, "[^A-Za-z0-9_.-]+", "_"), whole);
  }
  return fmt::format("= is missing between a key and its value; write {} = {}", key, trimmed(place.rest()));
}

TomlProblem unclosed(const TomlPlace& place, char bracket, const std::string& remedy) {
  for (std::size_t i = place.open.size(); i-- > 0;)
    if (place.text[place.open[i]] == bracket) return {place.moved_to(place.open[i]), remedy};
  return {place, remedy};
}

TomlProblem array_problem(const TomlPlace& place, std::string_view description) {
  if (has(description, "saw comma")) return {place, "a comma too many; remove it"};
  if (const std::string found = typographic_problem(place.character()); !found.empty()) return {place, found};
  const std::string_view line = trimmed(place.line);
  const bool is_new_line = trimmed(place.line.substr(0, place.at)).empty();
  if (place.at_end() || (is_new_line && (matches_pattern(line, "[A-Za-z0-9_.\"'-]+ *=.*") ||
                                         matches_pattern(line, "\\[.*[A-Za-z].*\\].*"))))
    return unclosed(place, '[',
                    place.at_end() ? "the list that begins here is not closed; ] is missing"
                                   : fmt::format("the list that begins here is not closed; ] is missing "
                                                 "before line {}",
                                                 place.line_number));
  if (place.character() == "}" || place.character() == ")")
    return unclosed(place, '[', "the list that begins here ends with another bracket; a list ends with ]");
  if (place.character() == ";") return {place, "values of a list are separated by commas"};
  return {place, "a comma is missing between two values of a list"};
}

TomlProblem inline_table_problem(const TomlPlace& place, std::string_view description) {
  if (has(description, "dangling comma")) return {place, "a comma too many before }; remove it"};
  if (place.at_end() || place.character() == "#")
    return unclosed(place, '{',
                    "what is in { } must end on its line; write all of it there, or as a table of its own: "
                    "[table] or [[table]]");
  if (place.character() == "," || place.character() == ";")
    return {place, "entries in { } are separated by one comma each"};
  if (has(description, "expected comma")) return {place, "a comma is missing between two entries in { }"};
  return {place, key_problem(place)};
}

TomlProblem string_problem(const TomlPlace& place, std::string_view description) {
  if (has(description, "unknown escape") || has(description, "unicode scalar"))
    return {place,
            "\\ in \"...\" begins a special sign; write paths with / or in single quotes: 'C:\\lamps'"};
  if (!place.quote) return {place, "a text is not closed; a quote is missing"};
  const TomlPlace begin = place.moved_to(*place.quote);
  const char mark = place.text[*place.quote];
  if (begin.rest().starts_with(std::string(3, mark)))
    return {begin,
            fmt::format("the text that begins here is not closed; {} is missing", std::string(3, mark))};
  if (!place.at_end()) return {place, "a control character in a text; remove it"};
  return {begin, fmt::format("the text that begins here is not closed; {} is missing at its end", mark)};
}

TomlProblem header_problem(const TomlPlace& place, std::string_view description) {
  if (has(description, "blank"))
    return {place, "the name of the table is missing; write [mesh], for example"};
  const bool is_list = trimmed(place.line).starts_with("[[");
  if (place.at_end() || place.character() == "#" || (is_list && trimmed(place.line).ends_with(']')))
    return {place, is_list ? "]] is missing behind the name of the table"
                           : "] is missing behind the name of the table"};
  return {
      place,
      "the name of a table has no spaces or other signs; put such a name in quotes: [walls.\"left side\"]"};
}

/// A line that begins with something else than a key, a table or a comment.
std::string line_problem(const TomlPlace& place) {
  const std::string_view here = place.character();
  if (const std::string found = typographic_problem(here); !found.empty()) return found;
  if (here == "=") return "a key is missing before =; write key = value";
  if (here == "]" || here == "}")
    return fmt::format("{} closes nothing; remove it, or open what it ends", here);
  if (here.size() == 1 && has("/;%!*", here)) return "a comment begins with #";
  if (here.size() > 1) return key_problem(place);
  return "a line is key = value, [table] or # comment";
}

}  // namespace

TomlProblem toml_problem(const TomlPlace& place, std::string_view description) {
  if (has(description, "utf-8")) {
    TomlPlace byte = place;
    byte.at = std::min(place.line.size(), first_invalid_utf8(place.line));
    return {byte, "not UTF-8 (Latin-1 or another encoding?); save the file as UTF-8"};
  }
  if (has(description, "maximum nested"))
    return {place, "brackets within brackets, too deep; a value needs few"};
  if (has(description, "parsing key:"))
    return trimmed(place.line).starts_with('[') ? header_problem(place, description)
                                                : TomlProblem{place, key_problem(place)};
  if (has(description, "array:")) return array_problem(place, description);
  if (has(description, "inline table:")) return inline_table_problem(place, description);
  if (has(description, "string") || has(description, "unicode scalar"))
    return string_problem(place, description);
  if (has(description, "expected a comment or whitespace") || has(description, "expected space or tab"))
    return {place, surplus_problem(place, description)};
  if (has(description, "table header:")) return header_problem(place, description);
  if (has(description, "expected '='")) return {place, key_problem(place)};
  const TomlPlace value = at_value(place);
  if (has(description, "boolean:")) return {value, value_problem(value)};
  if (has(description, "parsing value:") || has(description, "expected value"))
    return {place, value_problem(place)};
  if (has(description, "integer:") || has(description, "floating-point:") || has(description, "time:") ||
      has(description, "date"))
    return is_letter(value.character()) ? TomlProblem{value, value_problem(value)}
                                        : TomlProblem{place, number_problem(place, description)};
  if (has(description, "root table:")) return {place, line_problem(place)};
  return {place, "not TOML: " + std::string(description)};
}

}  // namespace etendue
