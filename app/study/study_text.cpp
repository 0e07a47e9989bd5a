// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "app/progress/text_table.h"
#include "app/study/study.h"

namespace etendue {
namespace {

constexpr std::size_t longest_level_table = 120;
constexpr double mebibyte = 1024.0 * 1024.0;

std::string formatted_or_empty(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "";
}

std::string seconds_text(const LevelResult& level) { return fmt::format("{:.3g}", level.seconds); }
std::string memory_text(const LevelResult& level) { return fmt::format("{:.0f}", level.memory / mebibyte); }

std::string limits_text(const std::vector<StudyRow>& rows, Refinement refinement) {
  const std::vector<StudyLimit> limits = study_limits(rows, refinement);
  if (limits.empty()) return "";
  TextTable table({"band", "quantity", "finest", "limit", "distance", "order"},
                  {Align::left, Align::left, Align::right, Align::right, Align::right, Align::right});
  for (const StudyLimit& limit : limits)
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
    errors[row->level->cells][row->level->directions] = formatted_or_empty(row->error, "{:.3e}");
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
  const StudyRow& row = *rows.front();
  return fmt::format("\nerror of {}, band {}, against the {}\n", row.value->quantity, row.value->band,
                     row.reference == ErrorReference::exact ? "exact value" : "finest level") +
         table.text();
}

std::string cost_table(const std::vector<LevelResult>& levels) {
  TextTable table({"level", "cells", "h", "directions", "sweeps", "seconds", "MiB"},
                  std::vector<Align>(7, Align::right));
  for (const LevelResult& level : levels)
    table.add_row({std::to_string(level.level), std::to_string(level.cells),
                   fmt::format("{:.4g}", level.size), std::to_string(level.directions),
                   std::to_string(level.sweeps), seconds_text(level), memory_text(level)});
  return table.text();
}

std::string surfaces_text(const std::vector<StudyRow>& rows, const std::vector<LevelResult>& levels) {
  std::string text =
      "\nstudy of mesh and directions together: the larger error hides the other, so no order is claimed\n" +
      cost_table(levels);
  std::vector<const StudyRow*> one;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    one.push_back(&rows[i]);
    if (i + 1 < rows.size() && is_same_quantity(rows[i], rows[i + 1])) continue;
    if (rows[i].value->quantity != "balance") text += surface_text(one);
    one.clear();
  }
  return text;
}

/// Levels whose iteration is seen in some errors.
std::string iteration_text(const std::vector<StudyRow>& rows, const std::vector<LevelResult>& levels) {
  std::string text;
  for (const LevelResult& level : levels) {
    const StudyRow* first = nullptr;
    int count = 0;
    for (const StudyRow& row : rows) {
      if (row.level != &level || !iteration_is_seen(row)) continue;
      if (!first) first = &row;
      ++count;
    }
    if (!first) continue;
    fmt::format_to(std::back_inserter(text),
                   "  level {}: the iteration errs by about {:.1e} in {}, band {}: more than a tenth of its "
                   "error {:.1e}{}; that has no order, lower solve.tolerance\n",
                   level.level, *first->iteration, first->value->quantity, first->value->band, *first->error,
                   count > 1 ? fmt::format(", and so with {} more", count - 1) : "");
  }
  return text;
}

std::string failures_text(const std::vector<StudyFailure>& failures) {
  std::string text;
  for (const StudyFailure& failure : failures)
    fmt::format_to(std::back_inserter(text), "  level {} failed and is left out: {}\n", failure.level,
                   failure.problem);
  return text;
}

std::string rows_text(const std::vector<StudyRow>& rows, Refinement refinement) {
  const bool all = rows.size() <= longest_level_table;
  TextTable table(
      {"level", "cells", "h", "directions", "band", "quantity", "value", "error", "iteration", "order",
       "reference", "sweeps", "seconds", "MiB"},
      {Align::right, Align::right, Align::right, Align::right, Align::left, Align::left, Align::right,
       Align::right, Align::right, Align::right, Align::left, Align::right, Align::right, Align::right});
  for (const StudyRow& row : rows) {
    if (!all && !is_norm(row.value->quantity) && row.value->quantity != "balance") continue;
    table.add_row({std::to_string(row.level->level), std::to_string(row.level->cells),
                   fmt::format("{:.4g}", row.level->size), std::to_string(row.level->directions),
                   row.value->band, row.value->quantity, number(row.value->value),
                   formatted_or_empty(row.error, "{:.3e}"), formatted_or_empty(row.iteration, "{:.0e}"),
                   formatted_or_empty(row.order, "{:.2f}"), name_of(row.reference),
                   std::to_string(row.level->sweeps), seconds_text(*row.level), memory_text(*row.level)});
  }
  std::string text =
      fmt::format("\nstudy of the {}; the order is that of the error against {}\n", name_of(refinement),
                  refinement == Refinement::mesh
                      ? "h = (volume/cells)^(1/3)"
                      : "the size of the directions, (4 pi/directions)^(1/2), in flatland 2 pi/directions");
  text += table.text();
  if (!all) text += "  probes, walls and regions: many, see study.csv\n";
  return text + limits_text(rows, refinement);
}

}  // namespace

std::string expectation_text(const Case& input, Refinement refinement) {
  if (!input.exact || !input.exact->family) return "";
  const ExactFamily& family = *input.exact->family;
  const auto order = expected_order(family, static_cast<int>(input.solve.order));
  const std::string told = "\nexact.family = \"" + family.name + "\": ";
  if (!order)
    return told + (family.name == "polynomial"
                       ? "the elements hold it, and sets of directions too: nothing errs\n"
                       : "the elements hold it, so meshes do not err, only directions\n");
  if (refinement != Refinement::mesh) {
    const bool smooth = family.name == "trigonometric";
    return smooth ? ""
                  : told +
                        "no set of directions is exact for it; errors below those of the product set of 648 "
                        "directions that stands for exactness cannot be seen\n";
  }
  return told + fmt::format("the best approximation has order {} of fluence_L2\n", *order);
}

std::string study_text(const std::vector<StudyRow>& rows, const std::vector<LevelResult>& levels,
                       Refinement refinement, const std::vector<StudyFailure>& failures) {
  if (levels.empty()) return "\nstudy: no level was finished\n" + failures_text(failures);
  const std::string tables =
      refinement == Refinement::both ? surfaces_text(rows, levels) : rows_text(rows, refinement);
  return tables + iteration_text(rows, levels) + failures_text(failures);
}

}  // namespace etendue
