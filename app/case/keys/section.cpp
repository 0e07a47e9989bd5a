// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/section.h"

#include <cassert>
#include <limits>
#include <stdexcept>

#include "app/case/keys/keys.h"
#include "app/case/toml/toml_document.h"

namespace etendue {
namespace {

void mark_asked(TomlNode& node) {
  node.asked = true;
  if (node.is_array())
    for (auto& item : node.array()) mark_asked(*item);
  if (node.is_table())
    for (auto& [name, item] : node.table().entries) mark_asked(*item);
}

TomlNode default_of(const KeyDeclaration& key, const Origin& origin) {
  TomlNode node = *parse_toml_value(key.default_value, origin);
  mark_asked(node);
  return node;
}

}  // namespace

Section::Section(TomlNode& table, std::string path, Faults& faults)
    : table_(table), path_(std::move(path)), faults_(faults) {
  table.asked = true;
}

TomlNode* Section::find(std::string_view name) {
  assert(find_key(path_, name) != nullptr || find_table(child_path(name)) != nullptr);
  TomlNode* node = table_.find(name);
  if (node == nullptr) return nullptr;
  mark_asked(*node);
  return node->faulty ? nullptr : node;
}

const TomlNode& Section::value(std::string_view name) {
  if (const TomlNode* node = find(name)) return *node;
  const KeyDeclaration* key = find_key(path_, name);
  if (key == nullptr || key->default_value.empty()) fail_without(name);
  TomlNode fallback = default_of(*key, origin(name));
  if (!has(name)) return table_.add(std::string(name), std::move(fallback));
  return *stand_ins_.emplace_back(std::make_unique<TomlNode>(std::move(fallback)));
}

void Section::fail_without(std::string_view name) const {
  if (!faults_.empty()) throw InputError(faults_);
  throw std::logic_error("no value and no default: " + origin(name).key);
}

const TomlNode* Section::find_or_default(std::string_view name) {
  if (const TomlNode* node = find(name)) return node;
  const KeyDeclaration* key = find_key(path_, name);
  return key == nullptr || key->default_value.empty() ? nullptr : &value(name);
}

std::optional<std::string> Section::text_if(std::string_view name) {
  const TomlNode* node = find(name);
  return node ? std::optional(node->text()) : std::nullopt;
}

std::optional<double> Section::number_if(std::string_view name) {
  const TomlNode* node = find(name);
  return node ? std::optional(node->number()) : std::nullopt;
}

std::optional<Vec3> Section::point_if(std::string_view name) {
  const TomlNode* node = find(name);
  return node ? std::optional(to_vec3(*node)) : std::nullopt;
}

std::string Section::text(std::string_view name) { return value(name).text(); }
double Section::number(std::string_view name) { return value(name).number(); }
int Section::integer(std::string_view name) { return static_cast<int>(value(name).number()); }
bool Section::boolean(std::string_view name) { return std::get<bool>(value(name).value); }

std::vector<std::string> Section::texts(std::string_view name) {
  std::vector<std::string> result;
  for (const auto& item : value(name).array()) result.push_back(item->text());
  return result;
}

void Section::resolve(std::string_view name, std::string value) {
  if (has(name)) return;
  TomlNode node;
  node.value = std::move(value);
  node.origin = origin(name);
  node.asked = true;
  table_.add(std::string(name), std::move(node));
}

Section Section::section(std::string_view name) {
  TomlNode* node = table_.find(name);
  if (node == nullptr) {
    TomlNode empty;
    empty.value = TomlTable{};
    empty.origin = origin(name);
    empty.position = std::numeric_limits<std::int64_t>::max();  // after all that the file has
    node = &table_.add(std::string(name), std::move(empty));
  }
  // One that is not a table has been reported; its reader sees an empty one.
  if (!node->is_table()) node->value = TomlTable{};
  return {*node, child_path(name), faults_};
}

std::vector<Section> Section::list(std::string_view name) {
  std::vector<Section> sections;
  TomlNode* node = table_.find(name);
  if (node == nullptr || node->faulty || !node->is_array()) return sections;
  node->asked = true;
  for (auto& item : node->array())
    if (item->is_table()) sections.emplace_back(*item, child_path(name), faults_);
  return sections;
}

std::vector<std::pair<std::string, Section>> Section::named() {
  std::vector<std::pair<std::string, Section>> sections;
  for (auto& [name, node] : table_.table().entries)
    if (node->is_table()) sections.emplace_back(name, Section(*node, child_path("NAME"), faults_));
  return sections;
}

Origin Section::origin(std::string_view name) const {
  if (const TomlNode* node = table_.find(name)) return node->origin;
  return {table_.origin.file, table_.origin.line, dotted_key(table_.origin.key, name)};
}

void Section::fault(std::string_view name, const std::string& problem) {
  if (TomlNode* node = table_.find(name))
    report(*node, problem, faults_);
  else
    faults_.push_back(fault_at(origin(name), "", problem));
}

void Section::fault(const std::string& problem) {
  table_.faulty = true;
  faults_.push_back(fault_at(origin(), "", problem));
}

void Section::unused(std::string_view name, const std::string& why) {
  TomlNode* node = table_.find(name);
  if (node == nullptr || node->faulty) return;
  mark_asked(*node);
  report(*node, "unused (" + why + "); remove it", faults_);
}

std::string Section::child_path(std::string_view name) const {
  return path_.empty() ? std::string(name) : path_ + "." + std::string(name);
}

}  // namespace etendue
