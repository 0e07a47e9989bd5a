// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/case/case.h"
#include "solver/adjoint/gradient.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"

namespace etendue {

/// What is written of the importance of one response.
struct ImportanceFields {
  const Case& input;
  const Problem& problem;
  const Solution& importance;          ///< AdjointSolution::importance
  std::string unit;                    ///< of the response by power
  const Gradient* gradient = nullptr;  ///< null: none is written
  std::string gradient_unit = {};      ///< of the response by the area of a coefficient in a volume
};

/// VTU: every cell with four points of its own. `importance` [band] is the response that a unit of power
/// brings which is emitted there alike in all directions; `importance_mean` its mean over the cell;
/// `gradient_absorption` and `gradient_scattering`, where there is a gradient, the functional derivatives:
/// those by the coefficient of the cell over its volume. `path` is written, `shown` is named in a FileError.
void write_importance(const ImportanceFields& fields, const std::filesystem::path& path,
                      const std::filesystem::path& shown);

/// VTP: every boundary triangle with three points of its own. `importance` [band] is the response that a unit
/// of power brings which the wall emits there by Lambert's law.
void write_importance_of_walls(const ImportanceFields& fields, const std::filesystem::path& path,
                               const std::filesystem::path& shown);

}  // namespace etendue
