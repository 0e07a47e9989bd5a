// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/study_trust.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "app/progress/text_table.h"

namespace etendue {
namespace {

/// Of the distance from a limit of three levels (Roache 1994, grid convergence index).
constexpr double safety = 1.25;
constexpr std::size_t longest_trust_table = 30;

const StudyValue* same_in(const LevelResult& level, const StudyValue& wanted) {
  const auto found = std::ranges::find_if(level.values, [&](const StudyValue& value) {
    return value.band == wanted.band && value.quantity == wanted.quantity;
  });
  return found == level.values.end() ? nullptr : &*found;
}

/// The level that has as much of one number as the finest and the next less of the other.
const LevelResult* next_coarser(const std::vector<LevelResult>& levels, const LevelResult& finest,
                                int LevelResult::*same, int LevelResult::*fewer) {
  const LevelResult* found = nullptr;
  for (const LevelResult& level : levels)
    if (level.*same == finest.*same && level.*fewer < finest.*fewer &&
        (found == nullptr || level.*fewer > found->*fewer))
      found = &level;
  return found;
}

std::optional<double> change_of(const StudyValue& value, const std::vector<LevelResult>& levels,
                                const LevelResult& finest) {
  std::optional<double> squares;
  for (const LevelResult* coarser :
       {next_coarser(levels, finest, &LevelResult::directions, &LevelResult::cells),
        next_coarser(levels, finest, &LevelResult::cells, &LevelResult::directions)}) {
    const StudyValue* before = coarser == nullptr ? nullptr : same_in(*coarser, value);
    if (before != nullptr) squares = squares.value_or(0) + std::pow(value.value - before->value, 2);
  }
  if (!squares) return std::nullopt;
  return std::sqrt(*squares);
}

double relative(const StudyTrust& entry) {
  const double size = std::abs(entry.value->value);
  return size > 0 ? entry.error / size : entry.error > 0 ? HUGE_VAL : 0.0;
}

std::string percent(double part) { return std::isinf(part) ? "-" : fmt::format("{:.2g} %", 100 * part); }

std::string left_out(Refinement refinement) {
  switch (refinement) {
    case Refinement::mesh:
      return "Errors of the directions are not in this: --refine directions shows them.\n";
    case Refinement::directions:
      return "Errors of the mesh are not in this: --refine mesh shows them.\n";
    case Refinement::both:
      break;
  }
  return "";
}

std::string alone_text(int asked) {
  return asked == 1 ? "\nOne level does not tell its error: ask for --levels 3.\n"
                    : "\nOne level alone is done, which does not tell its error.\n";
}

}  // namespace

const char* name_of(TrustBasis basis) {
  switch (basis) {
    case TrustBasis::exact:
      return "exact";
    case TrustBasis::limit:
      return "limit";
    case TrustBasis::change:
      break;
  }
  return "change";
}

std::vector<StudyTrust> study_trust(const std::vector<StudyRow>& rows, const std::vector<LevelResult>& levels,
                                    Refinement refinement) {
  std::vector<StudyTrust> trust;
  const LevelResult* const finest = finest_of(levels);
  if (finest == nullptr) return trust;
  const std::vector<StudyLimit> limits = study_limits(rows, refinement);
  for (const StudyValue& value : finest->values) {
    if (is_norm(value.quantity) || value.quantity == "balance") continue;
    const auto limit = std::ranges::find(limits, &value, &StudyLimit::finest);
    if (value.exact)
      trust.push_back({&value, std::abs(value.value - *value.exact), TrustBasis::exact});
    else if (limit != limits.end())
      trust.push_back({&value, safety * std::abs(limit->of.value - value.value), TrustBasis::limit});
    else if (const auto change = change_of(value, levels, *finest))
      trust.push_back({&value, *change, TrustBasis::change});
  }
  return trust;
}

std::string trust_text(const std::vector<StudyTrust>& trust, const std::vector<LevelResult>& levels,
                       Refinement refinement, int asked) {
  if (trust.empty()) return levels.size() == 1 ? alone_text(asked) : "";
  std::vector<StudyTrust> sorted = trust;
  std::ranges::stable_sort(sorted, std::greater(), relative);
  TextTable table({"band", "quantity", "value", "error", "relative", "from"},
                  {Align::left, Align::left, Align::right, Align::right, Align::right, Align::left});
  for (std::size_t i = 0; i < std::min(sorted.size(), longest_trust_table); ++i)
    table.add_row({sorted[i].value->band, sorted[i].value->quantity, number(sorted[i].value->value),
                   fmt::format("{:.1e}", sorted[i].error), percent(relative(sorted[i])),
                   name_of(sorted[i].basis)});
  const LevelResult& finest = *finest_of(levels);
  std::string text =
      fmt::format("\nhow far to trust level {} ({} cells, {} directions), largest errors first\n",
                  finest.level, finest.cells, finest.directions) +
      table.text();
  if (sorted.size() > longest_trust_table)
    fmt::format_to(std::back_inserter(text), "  {} more, each at most {}: study.json has them\n",
                   sorted.size() - longest_trust_table, percent(relative(sorted[longest_trust_table])));
  fmt::format_to(
      std::back_inserter(text),
      "{} of {} quantities are within 1 %, half of them within {}; the worst is {}, band {}: {}.\n",
      std::ranges::count_if(sorted, [](const StudyTrust& entry) { return relative(entry) <= 0.01; }),
      sorted.size(), percent(relative(sorted[sorted.size() / 2])), sorted[0].value->quantity,
      sorted[0].value->band, percent(relative(sorted[0])));
  return text + left_out(refinement);
}

}  // namespace etendue
