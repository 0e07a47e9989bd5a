// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "solver/measure/balance.h"
#include "solver/measure/probe.h"
#include "solver/ordinates/solution.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Wall-clock seconds of a run's stages, beside those of the solution.
struct RunSeconds {
  double read = 0;
  double mesh = 0;
  double write = 0;
  double total = 0;
};

/// A value of probes.csv.
struct ProbeRow {
  std::string name;
  int index = 0;
  Vec3 point = Vec3::Zero();
  std::vector<ProbeValue> values;                 ///< [band]
  std::optional<std::vector<double>> irradiance;  ///< [band], where a normal was given
};

/// All that the writers need; nothing of it is changed by them.
struct RunResult {
  const Case& input;
  const Problem& problem;
  const Solution& solution;
  std::vector<ProbeRow> probes;
  RunSeconds seconds;
  int threads = 1;
};

/// Writes every output of a run into the case's output directory: each file to a temporary name, renamed when
/// all are whole. Files that an earlier run wrote and this one does not are removed; others stay.
/// Throws FileError.
void write_results(const RunResult& result);

}  // namespace etendue
