// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/compare/method_answer.h"
#include "app/write/result/run_result.h"
#include "base/parallel/rank_group.h"

namespace etendue {

/// What is kept of a run whose errors are estimated.
struct KeptRun {
  std::vector<AnswerNumber> numbers;  ///< that people ask for, in an order that depends on the case alone
  std::filesystem::path directory;
  std::string method;  ///< "ordinates", "photons", "radiosity"
  std::string larger_patches;
  double cells = 0, directions = 0, histories = 0;
  int sweeps = 0;
  double seconds = 0;         ///< all of the run
  double of_directions = 0;   ///< what grows with the number of directions
  double of_points = 0;       ///< probes and sensors, as many on coarser cells
  double tolerance = 0;       ///< of the iteration
  double memory = 0;          ///< forecast of its peak [bytes]
  double order_of_cells = 2;  ///< of the error in the size of cells, at best
  bool is_flat = false;       ///< directions in the plane
  bool is_coarse = false;
  bool whole = false;
};

KeptRun kept_of(const RunResult& run);

/// The times and the memory of the first process, and whether all have all, so that all decide alike; null:
/// as they are.
void agree_on_costs(KeptRun& run, RankGroup* ranks);

/// What a number of `to` is more than in `from`; 0 where both are infinite, as UGR before a black background.
double change_of(const AnswerNumber& from, const AnswerNumber& to);

}  // namespace etendue
