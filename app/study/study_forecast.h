// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/study/study.h"

namespace etendue {

/// What a level of a study will take, about.
struct LevelForecast {
  int level = 0;  ///< from 1
  double cells = 0;
  double seconds = 0;
  double memory = 0;  ///< [bytes]
};

/// Of the levels after `done`, from a level that has run: eight times the cells take eight times as long and
/// as much memory beyond `floor` [bytes], which the program takes without cells; twice the order of
/// directions takes four times as long.
std::vector<LevelForecast> forecast_levels(const StudyRequest& study, const LevelResult& known, double floor,
                                           int done);

/// One line for each level, and the time that all take; empty without levels.
std::string forecast_text(const std::vector<LevelForecast>& levels, int level_count);

/// Cells and directions of the last level in those of the first, before anything has run.
std::string plan_text(const StudyRequest& study);

/// Why a level is not begun on a machine of so much memory [bytes]; empty if it may be.
std::string refusal_of(const LevelForecast& level, double installed);

}  // namespace etendue
