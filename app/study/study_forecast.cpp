// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/study_forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/setup/memory.h"
#include "app/study/study_level.h"
#include "base/gibibyte.h"

namespace etendue {
namespace {

/// Levels up to which each has a line.
constexpr std::size_t most_lines = 4;

double cells_in_first(const Refinements& times) { return std::ldexp(1.0, 3 * times.mesh); }
double work_in_first(const Refinements& times) {
  return cells_in_first(times) * std::ldexp(1.0, 2 * times.directions);
}

/// For people.
std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string forecast_text(const LevelForecast& level) {
  return fmt::format("about {:.0f} cells, {}, {:.2g} GiB", level.cells, duration_text(level.seconds),
                     level.memory / gibibyte);
}

}  // namespace

std::vector<LevelForecast> forecast_levels(const StudyRequest& study, const LevelResult& known, double floor,
                                           int done) {
  const Refinements base = refinements(study, known.level);
  std::vector<LevelForecast> levels;
  for (int level = done + 1; level <= level_count(study); ++level) {
    const Refinements times = refinements(study, level);
    const double cells = cells_in_first(times) / cells_in_first(base);
    levels.push_back({level, known.cells * cells, known.seconds * work_in_first(times) / work_in_first(base),
                      floor + std::max(0.0, known.memory - floor) * cells});
  }
  return levels;
}

std::string forecast_text(const std::vector<LevelForecast>& levels, int level_count) {
  if (levels.empty()) return "";
  double seconds = 0;
  for (const LevelForecast& level : levels) seconds += level.seconds;
  std::string text =
      fmt::format("study: {} of {} levels, about {} left\n", level_count - static_cast<int>(levels.size()),
                  level_count, duration_text(seconds));
  if (levels.size() <= most_lines)
    for (const LevelForecast& level : levels)
      fmt::format_to(std::back_inserter(text), "  level {}: {}\n", level.level, forecast_text(level));
  else
    fmt::format_to(std::back_inserter(text), "  the last: {}\n", forecast_text(levels.back()));
  return text;
}

std::string plan_text(const StudyRequest& study) {
  const int count = level_count(study);
  const Refinements last = refinements(study, count);
  return fmt::format(
      "study of the {}: {} levels; the last has {:.0f} times the cells and {:.0f} times the directions of "
      "the "
      "first\n",
      study.refinement == Refinement::both ? "mesh and the directions" : name_of(study.refinement), count,
      cells_in_first(last), std::ldexp(1.0, 2 * last.directions));
}

std::string refusal_of(const LevelForecast& level, double installed) {
  if (level.memory <= installed) return "";
  return fmt::format(
      "not begun: about {:.0f} cells would take some {:.2g} GiB, and this machine has {:.2g} GiB; begin with "
      "larger "
      "cells or ask for fewer levels",
      level.cells, level.memory / gibibyte, installed / gibibyte);
}

}  // namespace etendue
