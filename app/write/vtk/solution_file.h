// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "app/case/case.h"
#include "solver/problem/problem.h"
#include "solver/solution/saved_state.h"

namespace etendue {

/// What a solution.vtu holds.
struct SavedResult {
  SavedState state;
  std::vector<double> direction_error = {};  ///< as in Solution; empty where it is not known
};

/// solution.vtu: the mesh with the state of the iteration, to the last bit, and with hashes of the mesh and
/// of the parts of the case. `path` is written, `shown` is named in a FileError.
void write_solution(const Case& input, const Problem& problem, const SavedState& state,
                    std::span<const double> direction_error, const std::filesystem::path& path,
                    const std::filesystem::path& shown);

/// Throws what read_initial() would without knowing the mesh, which may take long to make.
void check_initial(const InputFile& file, const Case& input);

/// Reads the state that the case is to start from. Throws FileError where it cannot be read, and InputError
/// where it is that of another mesh or case, with what differs.
SavedState read_initial(const InputFile& file, const Case& input, const TetrahedralMesh& mesh);
/// The same with all that the file holds.
SavedResult read_result(const InputFile& file, const Case& input, const TetrahedralMesh& mesh);

/// Replaces the results in the case's output directory by solution.vtu alone: the state of a run that goes
/// on. The file is whole at any time. Throws FileError.
void write_checkpoint(const Case& input, const Problem& problem, const SavedState& state);

}  // namespace etendue
