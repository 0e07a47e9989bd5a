// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// A file for the folder of a time of an OpenFOAM case.
struct FoamFieldFile {
  std::string name;
  std::string text;
};

/// Fields on the cells and patches of the OpenFOAM case that the mesh was cut from, in their order:
/// `divergence` of the radiative heat flux in the cells [W/m^3], and `qr`, the radiative heat flux into the
/// patches [W/m^2]. None where the mesh has another origin, or where the divergence is not known.
std::vector<FoamFieldFile> foam_fields(const RunResult& result);

}  // namespace etendue
