// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/write/result/fingerprint.h"
#include "app/write/vtk/solution_file.h"

namespace etendue {

/// Changes with the meaning of what is in the file.
inline constexpr const char* solution_format = "etendue solution 2";

/// The parts of a state beside the fluence, which is data of the cells.
struct StatePart {
  const char* name;
  std::vector<double> SavedState::*values;
};
inline constexpr std::array<StatePart, 6> state_parts = {{{"moments", &SavedState::moments},
                                                          {"wall_irradiance", &SavedState::irradiance},
                                                          {"mirror_traces", &SavedState::mirrors},
                                                          {"lagged_traces", &SavedState::lagged},
                                                          {"radiance_where_dense", &SavedState::radiance},
                                                          {"photons", &SavedState::photons}}};

/// A saved solution with the mesh and the case that its file names.
struct SavedSolution {
  SavedResult result;
  std::string mesh;
  int cells = 0;
  std::vector<CasePart> case_parts;
};

/// The solution from the bytes of the process that reads its file; empty where it is not of this format or
/// its arrays do not fit together. Throws std::runtime_error where they are cut short.
std::optional<SavedSolution> take_solution(std::string_view bytes);

}  // namespace etendue
