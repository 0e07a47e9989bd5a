// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/command/richardson.h"
#include "app/command/study.h"
#include "app/command/text_table.h"

namespace etendue {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_table = 120;
constexpr double mebibyte = 1024.0 * 1024.0;
// The iteration must not be seen in the error of the discretisation.
constexpr double largest_part_of_iteration = 0.1;

bool is_norm(const std::string& quantity) { return quantity.starts_with("fluence_"); }

double refined_size(const LevelResult& level, Refinement refinement) {
  if (refinement == Refinement::mesh) return level.size;
  const double each = full_range(level.space) / level.directions;
  return level.space == AngularSpace::sphere ? std::sqrt(each) : each;
}

const StudyValue* find_value(const LevelResult& level, const StudyValue& like) {
  for (const StudyValue& value : level.values)
    if (value.band == like.band && value.quantity == like.quantity) return &value;
  return nullptr;
}

std::optional<double> error_of(const StudyRow& row, const StudyRow& finest) {
  if (row.value->exact) return std::abs(row.value->value - *row.value->exact);
  if (row.level == finest.level) return std::nullopt;
  return std::abs(row.value->value - finest.value->value);
}

/// Nothing can be said of an error that is zero or of a balance, which only the iteration disturbs.
std::optional<double> order_between(const StudyRow& coarse, const StudyRow& fine, Refinement refinement) {
  if (refinement == Refinement::both || fine.value->quantity == "balance" || !coarse.error || !fine.error)
    return std::nullopt;
  const double sizes =
      std::log(refined_size(*coarse.level, refinement) / refined_size(*fine.level, refinement));
  const double order = std::log(*coarse.error / *fine.error) / sizes;
  return std::isfinite(order) ? std::optional(order) : std::nullopt;
}

/// RFC 4180.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string or_empty(const std::optional<double>& value) { return value ? fmt::to_string(*value) : ""; }
std::string or_empty(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "";
}
Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// Where a quantity without an exact value goes, by its last three levels.
struct Limit {
  const StudyValue* finest;
  Extrapolation of;
};

bool is_same_quantity(const StudyRow& a, const StudyRow& b) {
  return a.value->quantity == b.value->quantity && a.value->band == b.value->band;
}

std::vector<Limit> limits_of(const std::vector<StudyRow>& rows, Refinement refinement) {
  std::vector<Limit> limits;
  if (refinement == Refinement::both) return limits;
  for (std::size_t i = 2; i < rows.size(); ++i) {
    const bool last = i + 1 == rows.size() || !is_same_quantity(rows[i], rows[i + 1]);
    if (!last || rows[i].value->exact || !is_same_quantity(rows[i], rows[i - 2])) continue;
    std::array<double, 3> sizes{}, values{};
    for (std::size_t k = 0; k < 3; ++k) {
      sizes[k] = refined_size(*rows[i - 2 + k].level, refinement);
      values[k] = rows[i - 2 + k].value->value;
    }
    if (const auto limit = richardson(sizes, values)) limits.push_back({rows[i].value, *limit});
  }
  return limits;
}

std::string limits_text(const std::vector<StudyRow>& rows, Refinement refinement) {
  const std::vector<Limit> limits = limits_of(rows, refinement);
  if (limits.empty()) return "";
  TextTable table({"band", "quantity", "finest", "limit", "distance", "order"},
                  {Align::left, Align::left, Align::right, Align::right, Align::right, Align::right});
  for (const Limit& limit : limits)
    table.add_row({limit.finest->band, limit.finest->quantity, number(limit.finest->value),
                   fmt::format("{:.8g}", limit.of.value),
                   fmt::format("{:.1e}", std::abs(limit.of.value - limit.finest->value)),
                   fmt::format("{:.2f}", limit.of.order)});
  return "\nwhere the last three levels go (Richardson)\n" + table.text();
}

/// One quantity where both are refined: a line for each mesh, a column for each set. Missing levels are
/// empty.
std::string surface_text(const std::vector<const StudyRow*>& rows) {
  std::map<int, std::map<int, std::string>> errors;  // [cells][directions]
  std::set<int> sets;
  for (const StudyRow* row : rows) {
    errors[row->level->cells][row->level->directions] = or_empty(row->error, "{:.3e}");
    sets.insert(row->level->directions);
  }
  std::vector<std::string> header = {"cells \\ directions"};
  for (const int directions : sets) header.push_back(std::to_string(directions));
  TextTable table(header, std::vector<Align>(header.size(), Align::right));
  for (auto& [cells, of_mesh] : errors) {
    std::vector<std::string> line = {std::to_string(cells)};
    for (const int directions : sets) line.push_back(of_mesh[directions]);
    table.add_row(line);
  }
  const StudyValue& value = *rows.front()->value;
  return fmt::format("\nerror of {}, band {}, against the {}\n", value.quantity, value.band,
                     value.exact ? "exact value" : "finest level") +
         table.text();
}

std::string surfaces_text(const std::vector<StudyRow>& rows) {
  std::string text =
      "\nstudy of mesh and directions together: the larger error hides the other, so no order is claimed\n";
  std::vector<const StudyRow*> one;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    one.push_back(&rows[i]);
    if (i + 1 < rows.size() && is_same_quantity(rows[i], rows[i + 1])) continue;
    if (rows[i].value->quantity != "balance") text += surface_text(one);
    one.clear();
  }
  return text;
}

/// Levels whose iteration is seen in the error of the fluence.
std::string iteration_text(const std::vector<StudyRow>& rows) {
  std::string text;
  for (const StudyRow& row : rows)
    if (row.value->quantity == "fluence_L2" && row.level->residual > largest_part_of_iteration * *row.error)
      text += fmt::format(
          "  level {}, band {}: the error of the iteration, about {:.1e}, is above a tenth of the error "
          "{:.1e}; lower "
          "solve.tolerance\n",
          row.level->level, row.value->band, row.level->residual, *row.error);
  return text;
}

}  // namespace

const char* name_of(Refinement refinement) {
  switch (refinement) {
    case Refinement::mesh:
      return "mesh";
    case Refinement::directions:
      return "directions";
    case Refinement::both:
      break;
  }
  return "both";
}

std::vector<StudyRow> study_rows(const std::vector<LevelResult>& levels, Refinement refinement) {
  std::vector<StudyRow> rows;
  if (levels.empty()) return rows;
  const LevelResult& last = levels.back();
  for (const StudyValue& finest : last.values) {
    const std::size_t first = rows.size();
    for (const LevelResult& level : levels)
      if (const StudyValue* value = find_value(level, finest)) {
        StudyRow row{&level, value, {}, {}};
        row.error = error_of(row, {&last, &finest, {}, {}});
        if (rows.size() > first) row.order = order_between(rows.back(), row, refinement);
        rows.push_back(row);
      }
  }
  return rows;
}

std::string study_csv(const std::vector<StudyRow>& rows, Refinement refinement) {
  std::string csv = "level,refined,cells,h,directions,band,quantity,value,error,order,sweeps,seconds\n";
  for (const StudyRow& row : rows)
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{},{},{},{}\n", row.level->level,
                   name_of(refinement), row.level->cells, row.level->size, row.level->directions,
                   quoted(row.value->band), quoted(row.value->quantity), row.value->value,
                   or_empty(row.error), or_empty(row.order), row.level->sweeps, row.level->seconds);
  return csv;
}

std::string study_json(const std::vector<StudyRow>& rows, Refinement refinement, const Case& input) {
  Json json = {{"title", input.title}, {"refined", name_of(refinement)}, {"rows", Json::array()}};
  if (input.exact && input.exact->family && refinement == Refinement::mesh)
    json["expected_order"] =
        or_null(expected_order(*input.exact->family, static_cast<int>(input.solve.order)));
  json["richardson"] = Json::array();
  for (const Limit& limit : limits_of(rows, refinement))
    json["richardson"].push_back({{"band", limit.finest->band},
                                  {"quantity", limit.finest->quantity},
                                  {"value", limit.of.value},
                                  {"order", limit.of.order}});
  for (const StudyRow& row : rows)
    json["rows"].push_back({{"level", row.level->level},
                            {"refined", name_of(refinement)},
                            {"cells", row.level->cells},
                            {"h", row.level->size},
                            {"directions", row.level->directions},
                            {"band", row.value->band},
                            {"quantity", row.value->quantity},
                            {"value", row.value->value},
                            {"reference", row.value->exact ? "exact" : "finest"},
                            {"error", or_null(row.error)},
                            {"order", or_null(row.order)},
                            {"sweeps", row.level->sweeps},
                            {"seconds", row.level->seconds},
                            {"memory", row.level->memory},
                            {"converged", row.level->converged}});
  json["case"] = input.resolved_toml;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string expectation_text(const Case& input, Refinement refinement) {
  if (!input.exact || !input.exact->family) return "";
  const ExactFamily& family = *input.exact->family;
  const auto order = expected_order(family, static_cast<int>(input.solve.order));
  const std::string told = "\nexact.family = \"" + family.name + "\": ";
  if (!order) return told + "the elements hold it, so meshes do not err, only directions\n";
  if (refinement != Refinement::mesh) return "";
  return told + fmt::format("theory promises order {} of fluence_L2 at least\n", *order);
}

std::string study_text(const std::vector<StudyRow>& rows, const std::vector<LevelResult>& levels,
                       Refinement refinement) {
  if (levels.empty()) return "\nstudy: no level was finished\n";
  if (refinement == Refinement::both) return surfaces_text(rows) + iteration_text(rows);
  const bool all = rows.size() <= longest_table;
  TextTable table(
      {"level", "cells", "h", "directions", "band", "quantity", "value", "error", "order", "reference",
       "sweeps", "seconds", "MiB"},
      {Align::right, Align::right, Align::right, Align::right, Align::left, Align::left, Align::right,
       Align::right, Align::right, Align::left, Align::right, Align::right, Align::right});
  for (const StudyRow& row : rows) {
    if (!all && !is_norm(row.value->quantity) && row.value->quantity != "balance") continue;
    table.add_row({std::to_string(row.level->level), std::to_string(row.level->cells),
                   fmt::format("{:.4g}", row.level->size), std::to_string(row.level->directions),
                   row.value->band, row.value->quantity, number(row.value->value),
                   or_empty(row.error, "{:.3e}"), or_empty(row.order, "{:.2f}"),
                   row.value->exact ? "exact" : "finest", std::to_string(row.level->sweeps),
                   fmt::format("{:.3g}", row.level->seconds),
                   fmt::format("{:.0f}", row.level->memory / mebibyte)});
  }
  std::string text =
      fmt::format("\nstudy of the {}; the order is that of the error against {}\n", name_of(refinement),
                  refinement == Refinement::mesh
                      ? "h = (volume/cells)^(1/3)"
                      : "the size of the directions, (4 pi/directions)^(1/2), in flatland 2 pi/directions");
  text += table.text();
  if (!all) text += "  probes, walls and regions: many, see study.csv\n";
  return text + limits_text(rows, refinement) + iteration_text(rows);
}

}  // namespace etendue
