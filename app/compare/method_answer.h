// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/request/commands.h"
#include "app/write/result/run_result.h"

namespace etendue {

/// One number of an answer.
struct AnswerNumber {
  std::string where;  ///< "region smoke", "wall floor", "probe across 3", "balance"
  std::string band;
  std::string quantity;  ///< "fluence", "absorbed", "incoming", …
  double value = 0;
  double error = 0;  ///< standard error, or what finer cells and directions may still change
};

/// What one method says of a case, and how sure it is.
struct MethodAnswer {
  std::string method;
  std::vector<AnswerNumber> numbers;
  std::vector<double> cells;        ///< [cell][band] mean fluence [power/length^2]
  std::vector<double> cell_errors;  ///< [cell][band]
  double seconds = 0;               ///< of the run, without those that only tell its error
  std::vector<std::string> notes;
  bool whole = true;  ///< not interrupted
};

/// The numbers of a run's steady light, in an order that depends on the case alone; errors are those of
/// photons, else 0.
std::vector<AnswerNumber> steady_numbers(const RunResult& run);

/// The answer of a run, of light in time too; errors are those of photons, else 0.
MethodAnswer answer_of(const RunResult& run);

/// Returns the override that repeats a case with other directions, of which the changes tell the error of its
/// own: a lower order that the set has, from half of it on; without any, twice the order.
std::string other_directions(const Case& input);
/// Returns the override that repeats a solution by radiosity on patches of four times the area.
std::string coarser_patches(const RunResult& run);

/// A case that is solved by several methods.
struct ComparedCase {
  const RunRequest& run;
  const std::filesystem::path& directory;  ///< results go into folders below it
  const TetrahedralMesh& mesh;             ///< of the case
};

/// Discrete ordinates: also runs the case once with about half the order of directions and once with eight
/// times the volume of cells; what they change is taken as the error, which is then rather too large.
MethodAnswer answer_by_ordinates(const ComparedCase& compared, std::ostream& out, std::ostream& err);

/// Photons: the standard errors are the errors.
MethodAnswer answer_by_photons(const ComparedCase& compared, std::ostream& out, std::ostream& err);

/// Radiosity: also runs the case once on patches of four times the area; what they change is taken as the
/// error, which is then rather too large.
MethodAnswer answer_by_radiosity(const ComparedCase& compared, std::ostream& out, std::ostream& err);

/// By its name: ordinates, photons or radiosity.
MethodAnswer answer_by(const std::string& method, const ComparedCase& compared, std::ostream& out,
                       std::ostream& err);

}  // namespace etendue
