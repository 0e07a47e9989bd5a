// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/toml/toml_document.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "app/case/toml/toml_fault.h"
#include "app/case/toml/toml_redefinition.h"

namespace etendue {
namespace {

/// Of a case file [bytes]. Meshes, tables and images have files of their own.
constexpr std::size_t largest_file = 64'000'000;

int line_of(const toml::source_region& source) { return static_cast<int>(source.begin.line); }

std::int64_t position_of(const toml::source_region& source) {
  return (static_cast<std::int64_t>(source.begin.line) << 32) + source.begin.column;
}

template <class DateOrTime>
TomlDate date_text(const DateOrTime& value) {
  std::ostringstream text;
  text << value;
  return {text.str()};
}

/// Turns the nodes of toml++ into ours; `file` is the same for all, and so is `line` where it is given.
class Conversion {
 public:
  explicit Conversion(std::string file, std::optional<int> line = {}) : file_(std::move(file)), line_(line) {}

  TomlNode node(const toml::node& from, const std::string& key) const {
    TomlNode result;
    result.origin = {file_, line(from.source()), key};
    result.position = position_of(from.source());
    switch (from.type()) {
      case toml::node_type::boolean:
        result.value = from.as_boolean()->get();
        break;
      case toml::node_type::integer:
        result.value = from.as_integer()->get();
        break;
      case toml::node_type::floating_point:
        result.value = from.as_floating_point()->get();
        break;
      case toml::node_type::string:
        result.value = from.as_string()->get();
        break;
      case toml::node_type::date:
        result.value = date_text(from.as_date()->get());
        break;
      case toml::node_type::time:
        result.value = date_text(from.as_time()->get());
        break;
      case toml::node_type::date_time:
        result.value = date_text(from.as_date_time()->get());
        break;
      case toml::node_type::array:
        result.value = array(*from.as_array(), key);
        break;
      default:
        result.value = table(*from.as_table(), key);
    }
    return result;
  }

 private:
  int line(const toml::source_region& source) const { return line_.value_or(line_of(source)); }

  TomlArray array(const toml::array& from, const std::string& key) const {
    TomlArray result;
    for (std::size_t i = 0; i < from.size(); ++i)
      result.push_back(std::make_unique<TomlNode>(node(*from.get(i), dotted_key(key, i))));
    return result;
  }

  TomlTable table(const toml::table& from, const std::string& key) const {
    TomlTable result;
    for (const auto& [name, value] : from) {
      auto converted = std::make_unique<TomlNode>(node(value, dotted_key(key, name.str())));
      converted->origin.line = line(name.source());
      converted->position = position_of(name.source());
      result.entries.push_back({std::string(name.str()), std::move(converted)});
    }
    // toml++ sorts tables by key; the file's order means something here.
    std::stable_sort(
        result.entries.begin(), result.entries.end(),
        [](const TomlEntry& a, const TomlEntry& b) { return a.node->position < b.node->position; });
    return result;
  }

  std::string file_;
  std::optional<int> line_;
};

std::string message_of(std::string_view text, const std::string& file, const toml::parse_error& error) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark has no column
  const toml::source_position& position = error.source().begin;
  TomlPlace place = toml_place(text, static_cast<int>(position.line), static_cast<int>(position.column));
  const bool is_twice = error.description().find("cannot redefine existing") != std::string_view::npos;
  if (is_twice) place = redefinition_place(place);
  const std::string twice = is_twice ? redefinition_problem(place) : "";
  return toml_message(twice.empty() ? toml_problem(place, error.description()) : TomlProblem{place, twice},
                      file);
}

void reject_binary(std::string_view text, const std::string& file) {
  const std::size_t nul = text.find('\0');
  if (nul == std::string_view::npos) return;
  const auto before = text.substr(0, nul);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  throw InputError(Fault{file, static_cast<int>(line),
                         "a NUL byte (the file is not text in UTF-8); a case is a TOML file"});
}

}  // namespace

TomlNode parse_toml(std::string_view text, const std::string& file) {
  reject_binary(text, file);
  try {
    const toml::table root = toml::parse(text);
    TomlNode result = Conversion(file).node(root, "");
    result.origin.line = 0;
    return result;
  } catch (const toml::parse_error& error) {
    throw InputError(message_of(text, file, error));
  }
}

TomlNode read_toml(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code problem;
  if (std::filesystem::is_directory(file, problem))
    throw FileError(name, "is a directory; give the case file in it");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(name, std::string("cannot be opened (") + std::strerror(errno) + ")");
  std::string text;
  std::array<char, 1 << 16> part{};
  while (text.size() <= largest_file && (stream.read(part.data(), part.size()), stream.gcount() > 0))
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) throw FileError(name, "cannot be read");
  if (text.size() > largest_file)
    throw FileError(name, "is larger than 64 MB, which no case file is; give the case file");
  return parse_toml(text, name);
}

std::optional<TomlNode> parse_toml_value(std::string_view text, const Origin& origin) {
  toml::table root;
  try {
    root = toml::parse("value = " + std::string(text));
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
  if (root.size() != 1 || !root.contains("value")) return std::nullopt;  // a line break and another key
  return Conversion(origin.file, origin.line).node(*root.get("value"), origin.key);
}

}  // namespace etendue
