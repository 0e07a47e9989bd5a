// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "solver/exact/exact_comparison.h"
#include "solver/measure/balance.h"
#include "solver/measure/probe.h"
#include "solver/ordinates/solution.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Wall-clock seconds of a run up to its writing, beside those of the solution's stages.
struct RunSeconds {
  double read = 0;
  double mesh = 0;
  double total = 0;  ///< from the start of the program to the start of the writing
};

/// A value of probes.csv.
struct ProbeRow {
  std::string name;
  int index = 0;
  Vec3 point = Vec3::Zero();
  std::vector<ProbeValue> values;                 ///< [band]
  std::optional<std::vector<double>> irradiance;  ///< [band], where a normal was given
  /// [band] of the P1 field, where uncollided light makes `values` differ from it
  std::optional<std::vector<double>> fluence_field = {};
};

/// All that the writers need; nothing of it is changed by them.
struct RunResult {
  const Case& input;
  const Problem& problem;
  const Solution& solution;
  std::vector<ProbeRow> probes;                   ///< in the order of the case
  std::vector<Balance> balances;                  ///< [band]
  std::vector<std::vector<WallPower>> walls;      ///< [wall][band]
  std::vector<std::vector<RegionPower>> regions;  ///< [region][band]
  std::optional<ExactComparison> exact = {};      ///< of a case that says what the answer is
  RunSeconds seconds;
  int threads = 1;
};

/// What was written, and how long that took.
struct WrittenResults {
  std::filesystem::path directory;
  std::vector<std::string> files;  ///< names in the directory
  double seconds = 0;
};

/// Writes every output of a run into the case's output directory: each file to a temporary name, renamed when
/// all are whole. Files that an earlier run wrote and this one does not are removed; others stay.
/// Throws FileError, and then no file has changed.
WrittenResults write_results(const RunResult& result);

/// Version of the program.
std::string program_version();

}  // namespace etendue
