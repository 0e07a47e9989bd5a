// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/band_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/case/values/field_value.h"
#include "app/case/values/gas_bands.h"
#include "solver/materials/media/angular_formula.h"

namespace etendue {
namespace {

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

// The parser's complaint; empty where the text is a formula in these variables.
std::string formula_problem(const std::string& text, std::vector<std::string> variables) {
  try {
    Expression(text, std::move(variables));
    return "";
  } catch (const InputError& error) {
    return error.faults().front().text;
  }
}

std::vector<std::string> names_of(FormulaOf variables) {
  switch (variables) {
    case FormulaOf::place:
      return {"x", "y", "z"};
    case FormulaOf::place_and_direction:
      return angular_variables();
    case FormulaOf::place_and_temperature:
      break;
  }
  return {"x", "y", "z", "T"};
}

void check_formula(TomlNode& node, FormulaOf variables, Faults& faults) {
  const std::string problem = formula_problem(node.text(), names_of(variables));
  if (problem.empty()) return;
  if (formula_problem(node.text(), angular_variables()).empty())
    report(node,
           "uses the direction of travel wx, wy, wz (absorption, extinction, emission and a wall's radiance "
           "may, this may not); use x, y, z",
           faults);
  else
    report(node,
           fmt::format("is not a formula ({}); use a number or a formula in {}", problem,
                       joined(names_of(variables))),
           faults);
}

Value value_in(const TomlNode& node) {
  if (node.is_text()) return node.text();
  return node.number();
}

// Empty where a file is faulty.
std::optional<Value> value_in(TomlNode& node, const std::string& function, Faults& faults) {
  if (!node.is_table()) return value_in(node);
  return read_field_value(node, function, faults);
}

std::optional<BandValues> values_in(TomlNode& node, std::string_view name, Faults& faults) {
  BandValues result;
  result.origin = node.origin;
  std::vector<TomlNode*> items = {&node};
  if (node.is_array()) {
    items.clear();
    for (const auto& item : node.array()) items.push_back(item.get());
  }
  for (std::size_t band = 0; band < items.size(); ++band) {
    // Of one medium, whose coefficients may be in one formula.
    std::optional<Value> value = value_in(*items[band], fmt::format("{}_of_file_{}", name, band), faults);
    if (!value) node.faulty = true;
    result.values.push_back(value.value_or(0.0));
  }
  if (node.faulty) return std::nullopt;
  return result;
}

void check_edges(Section& section, const TomlNode& edges, std::size_t band_count) {
  std::vector<double> values;
  for (const auto& item : edges.array()) values.push_back(item->number());
  const bool rising = std::ranges::is_sorted(values, std::less_equal<>{});
  const bool falling = std::ranges::is_sorted(values, std::greater_equal<>{});
  if (!rising && !falling) section.fault("edges", "must rise or fall throughout; use wavelengths in order");
  if (band_count > 0 && values.size() != band_count + 1)
    section.fault("edges", fmt::format("has {} {} for {} {}; use one more than names", values.size(),
                                       values.size() == 1 ? "entry" : "entries", band_count,
                                       band_count == 1 ? "band" : "bands"));
}

bool has_control_character(const std::string& text) {
  return std::ranges::any_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

}  // namespace

Bands read_bands(Section section, const std::filesystem::path& case_folder,
                 const std::optional<BandValues>& molar_ratio) {
  if (section.has("wsgg") || section.has("k_distribution"))
    return read_gas_bands(section, case_folder, molar_ratio);
  section.unused("molar_ratio", "there is no wsgg");
  Bands bands;
  bands.names = section.texts("names");
  if (std::ranges::any_of(bands.names, has_control_character))
    section.fault("names",
                  "has a name with a control character (files of results cannot hold it); use names "
                  "in one line without tabs");
  if (section.node().find("names")->faulty) bands.names.clear();
  if (std::set(bands.names.begin(), bands.names.end()).size() != bands.names.size())
    section.fault("names", "has a name twice; give each band its own");
  if (const TomlNode* edges = section.find("edges")) {
    check_edges(section, *edges, bands.names.size());
    for (const auto& item : edges->array()) bands.edges.push_back(item->number());
  }
  return bands;
}

bool check_band_count(Section& section, std::string_view name, std::size_t count, const Bands& bands) {
  const std::size_t band_count = bands.names.size();
  if (band_count == 0 || count == band_count) return true;
  section.fault(name, fmt::format("has {} {} for {} {} ({}); use one value, or a list with one for each band",
                                  count, count == 1 ? "entry" : "entries", band_count,
                                  band_count == 1 ? "band" : "bands", joined(bands.names)));
  return false;
}

std::optional<BandValues> read_band_values(Section& section, std::string_view name, const Bands& bands,
                                           FormulaOf formula) {
  TomlNode* node = section.find(name);
  if (node == nullptr) return std::nullopt;
  if (node->is_array() && !check_band_count(section, name, node->array().size(), bands)) return std::nullopt;
  if (node->is_text()) check_formula(*node, formula, section.faults());
  if (node->is_array())
    for (auto& item : node->array())
      if (item->is_text()) check_formula(*item, formula, section.faults());
  return values_in(*node, name, section.faults());
}

std::optional<BandValues> read_place_value(Section& section, std::string_view name, FormulaOf formula) {
  TomlNode* node = section.find(name);
  if (node == nullptr) return std::nullopt;
  if (node->is_text()) check_formula(*node, formula, section.faults());
  return values_in(*node, name, section.faults());
}

BandValues read_band_values_or_default(Section& section, std::string_view name, const Bands& bands,
                                       FormulaOf formula) {
  if (auto values = read_band_values(section, name, bands, formula)) return *values;
  const TomlNode& fallback = section.value(name);
  return {{value_in(fallback)}, fallback.origin};
}

bool depend_on_direction(const std::optional<BandValues>& values) {
  return values && std::ranges::any_of(values->values, [](const Value& value) {
           const auto* text = std::get_if<Formula>(&value);
           return text != nullptr && depends_on_direction(*text);
         });
}

const Value& value_of(const BandValues& values, int band) {
  return values.values.size() == 1 ? values.values.front() : values.values[static_cast<std::size_t>(band)];
}

}  // namespace etendue
