// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/override.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "app/case/toml/toml_document.h"
#include "base/text/trimmed.h"

namespace etendue {
namespace {

struct Assignment {
  std::vector<std::string> path;
  std::string value;
};

/// Reads the key of an override from its beginning to the equals sign.
class KeyReader {
 public:
  explicit KeyReader(const std::string& text) : text_(text) {}

  /// Empty where the text is not `key=value`.
  std::optional<Assignment> read() {
    Assignment result;
    while (true) {
      std::optional<std::string> part = next_part();
      if (!part) return std::nullopt;
      result.path.push_back(std::move(*part));
      skip_spaces();
      if (take('=')) {
        result.value = text_.substr(at_);
        return result;
      }
      if (!take('.') && peek() != '[') return std::nullopt;
    }
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void skip_spaces() {
    while (peek() == ' ' || peek() == '\t') ++at_;
  }

  std::optional<std::string> next_part() {
    skip_spaces();
    if (take('[')) return until("]");
    if (take('"')) return until("\"");
    if (take('\'')) return until("'");
    const std::size_t end = std::min(text_.find_first_of(".=[ \t", at_), text_.size());
    if (end == at_) return std::nullopt;
    std::string part = text_.substr(at_, end - at_);
    at_ = end;
    return part;
  }

  std::optional<std::string> until(std::string_view closing) {
    const std::size_t end = text_.find(closing, at_);
    if (end == std::string::npos) return std::nullopt;
    std::string part = text_.substr(at_, end - at_);
    at_ = end + 1;
    return part;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

std::optional<std::size_t> index_of(const std::string& part) {
  std::size_t index = 0;
  const char* end = part.data() + part.size();
  const auto [last, error] = std::from_chars(part.data(), end, index);
  return error == std::errc() && last == end ? std::optional(index) : std::nullopt;
}

TomlNode empty_table(const std::string& key) {
  TomlNode node;
  node.value = TomlTable{};
  node.origin = {override_file, 0, key};
  node.position = std::numeric_limits<std::int64_t>::max();  // after all that the file has
  return node;
}

// What replaces a value stands where it stood.
void set_position(TomlNode& node, std::int64_t position) {
  node.position = position;
  if (node.is_array())
    for (auto& item : node.array()) set_position(*item, position);
  if (node.is_table())
    for (auto& [name, item] : node.table().entries) set_position(*item, position);
}

std::string list_problem(const TomlNode& list) {
  const std::size_t count = list.array().size();
  const std::string entries =
      fmt::format("{} has {} {}", list.origin.key, count, count == 1 ? "entry" : "entries");
  if (count == 0) return entries;
  const std::string first = fmt::format("{}; use {}[0]", entries, list.origin.key);
  return count == 1 ? first : fmt::format("{} to [{}]", first, count - 1);
}

/// Where the parts of the path lead; tables that are missing are made. Empty, with the problem, where a part
/// leads nowhere.
TomlNode* follow(TomlNode& root, const std::vector<std::string>& path, std::string& problem) {
  TomlNode* node = &root;
  for (const std::string& part : path) {
    if (node->is_array()) {
      const auto index = index_of(part);
      if (!index || *index >= node->array().size()) {
        problem = "no such entry; " + list_problem(*node);
        return nullptr;
      }
      node = node->array()[*index].get();
    } else if (node->is_table()) {
      TomlNode* child = node->find(part);
      node = child ? child : &node->add(part, empty_table(dotted_key(node->origin.key, part)));
    } else {
      problem = fmt::format("no such key; {} is {}, not a table", node->origin.key, kind_of(*node));
      return nullptr;
    }
  }
  return node;
}

TomlNode value_node(const std::string& text, const std::string& key) {
  const Origin origin{override_file, 0, key};
  if (auto node = parse_toml_value(text, origin)) return std::move(*node);
  TomlNode node;
  node.value = std::string(trimmed(text));
  node.origin = origin;
  return node;
}

}  // namespace

void apply_override(TomlNode& root, const std::string& assignment, Faults& faults) {
  const std::optional<Assignment> read = KeyReader(assignment).read();
  if (!read) {
    faults.push_back(
        {override_file, 0, assignment + ": not an assignment; use key=value, as solve.tolerance=1e-8"});
    return;
  }
  std::string problem;
  TomlNode* target = follow(root, read->path, problem);
  if (target == nullptr) {
    faults.push_back({override_file, 0, assignment + ": " + problem});
    return;
  }
  const std::int64_t position = target->position;
  *target = value_node(read->value, target->origin.key);
  set_position(*target, position);
}

}  // namespace etendue
