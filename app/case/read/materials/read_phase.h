// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/case/keys/section.h"
#include "base/angular_space.h"
#include "solver/materials/phase/phase_function.h"
#include "solver/problem/bands.h"

namespace etendue {

/// What a phase function is read with. Files that it names are found beside the case.
struct PhaseContext {
  AngularSpace space;
  const std::filesystem::path& case_folder;
  const Bands& bands;
  int band = 0;                               ///< that the function is for
  std::vector<std::string>* notes = nullptr;  ///< what was computed on the way is told here
};

/// A table [media.NAME.phase].
PhaseFunction read_phase(Section phase, const PhaseContext& context);
/// Whether it, or a part of its mixture, depends on the wavelength of the band.
bool depends_on_band(Section phase);

}  // namespace etendue
