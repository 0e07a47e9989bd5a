// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/write/result/run_record.h"
#include "app/write/result/time_result.h"
#include "base/parallel/rank_group.h"
#include "solver/exact/exact_comparison.h"
#include "solver/heat/heat_solution.h"
#include "solver/observe/sensors/measurement.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/problem/problem.h"
#include "solver/radiosity/solve/solve_radiosity.h"
#include "solver/solution/balance.h"
#include "solver/solution/probe.h"
#include "solver/solution/solution.h"

namespace etendue {

/// Processes that shared a run.
struct RunRanks {
  int count = 1;
  RankTraffic of_first = {};  ///< up to the end of the solution
};

/// Wall-clock seconds of a run up to its writing, beside those of the solution's stages.
struct RunSeconds {
  double read = 0;
  double mesh = 0;
  double setup = 0;     ///< problem, lights, directions and checks
  double rays = 0;      ///< what rays of sensors and cameras look at
  double probes = 0;    ///< beside the solution
  double sensors = 0;   ///< beside the solution
  double measures = 0;  ///< powers of walls and regions, balances, errors
  double total = 0;     ///< from the start of the program to the start of the writing
};

/// The standard errors of a probe's values.
struct ProbeErrors {
  std::vector<ProbeValue> values;                 ///< [band]
  std::optional<std::vector<double>> irradiance;  ///< [band]
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
  std::optional<ProbeErrors> errors = {};  ///< where values are Monte Carlo estimates
  std::optional<double> temperature = {};  ///< of the medium, given or following [K]
};

/// What a sensor of the case showed.
struct SensorRow {
  const SensorCase& place;
  SensorReading reading;
};

/// Standard errors of the values that a run writes, where they are Monte Carlo estimates: each in the place
/// of its value.
struct RunErrors {
  std::vector<double> fluence;       ///< [cell][4][band]
  std::vector<double> fluence_mean;  ///< [cell][band]
  std::vector<double> net_flux;      ///< [cell][4][3][band]
  std::vector<double> irradiance;    ///< [boundary face][3][band]
  std::vector<Balance> balances;
  std::vector<std::vector<WallPower>> walls;
  std::vector<std::vector<double>> net;  ///< [wall][band] of incoming - outgoing, which are not independent
  std::vector<std::vector<RegionPower>> regions;
  PhotonReport report;
  double histories = 0;      ///< per band, all runs
  int unreached_probes = 0;  ///< values of probes that no history reached: their errors are upper bounds
};

/// All that the writers need; nothing of it is changed by them.
struct RunResult {
  const Case& input;
  const Problem& problem;
  const Solution& solution;
  std::vector<ProbeRow> probes;                   ///< in the order of the case
  std::vector<SensorRow> sensors = {};            ///< in the order of the case
  std::vector<Balance> balances;                  ///< [band]
  std::vector<std::vector<WallPower>> walls;      ///< [wall][band]
  std::vector<std::vector<RegionPower>> regions;  ///< [region][band]
  std::optional<RunErrors> errors = {};           ///< of a solution by photons
  std::optional<RadiosityReport> radiosity = {};
  std::vector<Solution> passes = {};  ///< walls after the first passes of radiosity
  /// Light on patches that are finer than faces: of the solution, and of the passes.
  std::optional<PatchLight> patches = {};
  std::vector<PatchLight> pass_patches = {};
  std::optional<ExactComparison> exact = {};  ///< of a case that says what the answer is
  RunSeconds seconds;
  int threads = 1;
  std::optional<RunRanks> ranks = {};  ///< of a run that several processes share
  RunRecord record = {};
  std::optional<HeatSolution> heat = {};   ///< of temperatures that follow by iteration
  std::optional<TimeResult> time = {};     ///< of a case with [time]
  double expected_memory = 0;              ///< forecast of its peak, an upper bound [bytes]; 0: none
  bool is_coarse = false;                  ///< known before the sweeps: cells or directions too coarse
  std::vector<std::string> left_out = {};  ///< what an interruption left out: "3 of 5 sensors"

  /// Whether a signal ended the iteration, or the reading of probes and sensors.
  bool interrupted() const { return solution.interrupted || !left_out.empty(); }
};

}  // namespace etendue
