// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/study/study.h"

namespace etendue {
namespace {

// The iteration must not be seen in the error of the discretisation.
constexpr double largest_part_of_iteration = 0.1;

const StudyValue* find_value(const LevelResult& level, const StudyValue& like) {
  for (const StudyValue& value : level.values)
    if (value.band == like.band && value.quantity == like.quantity) return &value;
  return nullptr;
}

/// The residual estimates the relative error of the fluence in L2; of a single value it is taken for the
/// same.
std::optional<double> iteration_of(const LevelResult& level, const StudyValue& value) {
  if (value.quantity == "balance") return std::nullopt;
  return level.residual * (is_norm(value.quantity) ? 1 : std::abs(value.value));
}

/// Where the last three of a quantity's rows go; nothing where the iteration is seen in their differences.
std::optional<Extrapolation> limit_of(std::span<const StudyRow> rows, Refinement refinement) {
  if (rows.size() < 3 || refinement == Refinement::both) return std::nullopt;
  const std::span<const StudyRow> last = rows.last(3);
  const StudyValue& finest = *last[2].value;
  if (finest.exact || is_norm(finest.quantity)) return std::nullopt;
  std::array<double, 3> sizes{}, values{};
  for (std::size_t k = 0; k < 3; ++k) {
    sizes[k] = refined_size(*last[k].level, refinement);
    values[k] = last[k].value->value;
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (last[k].iteration.value_or(0) > largest_part_of_iteration * std::abs(values[2] - values[1]))
      return std::nullopt;
  return richardson(sizes, values);
}

void add_errors(std::span<StudyRow> rows, Refinement refinement, StudyReference against,
                const LevelResult* finest_level) {
  const auto finest =
      std::ranges::find_if(rows, [&](const StudyRow& row) { return row.level == finest_level; });
  const std::optional<Extrapolation> limit =
      against == StudyReference::richardson ? limit_of(rows, refinement) : std::nullopt;
  for (StudyRow& row : rows) {
    row.reference = row.value->exact ? ErrorReference::exact
                    : limit          ? ErrorReference::richardson
                                     : ErrorReference::finest;
    if (row.value->exact)
      row.error = std::abs(row.value->value - *row.value->exact);
    else if (limit)
      row.error = std::abs(row.value->value - limit->value);
    else if (finest != rows.end() && &row != &*finest)
      row.error = std::abs(row.value->value - finest->value->value);
  }
}

/// Nothing can be said of an error that is zero or in which the iteration is seen.
std::optional<double> order_between(const StudyRow& coarse, const StudyRow& fine, Refinement refinement) {
  if (refinement == Refinement::both || fine.value->quantity == "balance" || !coarse.error || !fine.error ||
      iteration_is_seen(coarse) || iteration_is_seen(fine))
    return std::nullopt;
  const double sizes =
      std::log(refined_size(*coarse.level, refinement) / refined_size(*fine.level, refinement));
  const double order = std::log(*coarse.error / *fine.error) / sizes;
  return std::isfinite(order) ? std::optional(order) : std::nullopt;
}

}  // namespace

double refined_size(const LevelResult& level, Refinement refinement) {
  if (refinement == Refinement::mesh) return level.size;
  const double each = full_range(level.space) / level.directions;
  return level.space == AngularSpace::sphere ? std::sqrt(each) : each;
}

const LevelResult* finest_of(const std::vector<LevelResult>& levels) {
  const auto finest = std::ranges::find_if(levels, [&](const LevelResult& level) {
    return std::ranges::all_of(levels, [&](const LevelResult& other) {
      return other.cells <= level.cells && other.directions <= level.directions;
    });
  });
  return finest == levels.end() ? nullptr : &*finest;
}

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

const char* name_of(ErrorReference reference) {
  switch (reference) {
    case ErrorReference::exact:
      return "exact";
    case ErrorReference::finest:
      return "finest";
    case ErrorReference::richardson:
      break;
  }
  return "richardson";
}

bool is_norm(const std::string& quantity) { return quantity.starts_with("fluence_"); }

bool is_same_quantity(const StudyRow& a, const StudyRow& b) {
  return a.value->quantity == b.value->quantity && a.value->band == b.value->band;
}

bool iteration_is_seen(const StudyRow& row) {
  return row.error && row.iteration && *row.iteration > largest_part_of_iteration * *row.error;
}

std::vector<StudyRow> study_rows(const std::vector<LevelResult>& levels, Refinement refinement,
                                 StudyReference against) {
  std::vector<StudyRow> rows;
  if (levels.empty()) return rows;
  for (const StudyValue& finest : levels.back().values) {
    const std::size_t first = rows.size();
    for (const LevelResult& level : levels)
      if (const StudyValue* value = find_value(level, finest)) {
        StudyRow& row = rows.emplace_back();
        row.level = &level;
        row.value = value;
        row.iteration = iteration_of(level, *value);
      }
    const std::span<StudyRow> of_quantity = std::span(rows).subspan(first);
    add_errors(of_quantity, refinement, against, finest_of(levels));
    // The last three levels made the limit.
    const bool fitted = of_quantity.back().reference == ErrorReference::richardson;
    for (std::size_t i = 1; i + (fitted ? 2 : 0) < of_quantity.size(); ++i)
      of_quantity[i].order = order_between(of_quantity[i - 1], of_quantity[i], refinement);
  }
  return rows;
}

std::vector<StudyLimit> study_limits(const std::vector<StudyRow>& rows, Refinement refinement) {
  std::vector<StudyLimit> limits;
  const std::span<const StudyRow> all(rows);
  for (std::size_t first = 0, i = 0; i < rows.size(); ++i) {
    if (i + 1 < rows.size() && is_same_quantity(rows[i], rows[i + 1])) continue;
    if (const auto limit = limit_of(all.subspan(first, i + 1 - first), refinement))
      limits.push_back({rows[i].value, *limit});
    first = i + 1;
  }
  return limits;
}

}  // namespace etendue
