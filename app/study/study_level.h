// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/study/study.h"
#include "app/write/result/run_result.h"

namespace etendue {

/// How often mesh and directions of a level are refined.
struct Refinements {
  int mesh = 0;
  int directions = 0;
};
/// What makes the case's directions or mesh finer, `times` times: the order doubled, volumes divided by 8;
/// coarser where `times` is negative. Throws InputError where that cannot be.
std::string refined_directions(const Case& input, int times);
std::string refined_mesh(const Case& input, int times);
/// Cells whose size is this multiple of the case's. Throws as the last.
std::string resized_mesh(const Case& input, double factor);
/// The same by cutting cells into eight, for which `times` is not negative.
std::string split_mesh(const Case& input, int times);
/// Of level `level` (from 1); of both, the directions go first.
Refinements refinements(const StudyRequest& study, int level);
/// Levels of a study: of both, those of the grid.
int level_count(const StudyRequest& study);

/// The case of level `level` (from 1): volumes divided by 8, or the order doubled, once for each level after
/// the first; results go into the folder level-N of the case's own. Throws InputError where that cannot be.
RunRequest level_request(const StudyRequest& study, const Case& input, int level);

/// What a study keeps of a run. Where the directions are refined, the exact values are integrals over the
/// whole sphere, and those of walls are not known.
LevelResult level_result(const RunResult& run, int level, Refinement refinement);

/// Writes what was kept beside the level's results. Throws FileError.
void save_level(const LevelResult& result, const Case& input, Refinement refinement);
/// What an earlier study kept, if its results are whole and were made by the same case.
std::optional<LevelResult> saved_level(const Case& input, int level, Refinement refinement);

}  // namespace etendue
