// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// What media are read with.
struct MatterContext {
  const Bands& bands;
  const std::optional<BandValues>& molar_ratio;  ///< Case::molar_ratio
  const Units& units;
  AngularSpace space;
  std::filesystem::path case_folder;
  std::function<int()> ordinates;  ///< how many directions the case has; 0 where they are faulty
};

/// What walls are read with.
struct WallContext {
  const Bands& bands;
  const std::optional<BandValues>& molar_ratio;  ///< Case::molar_ratio
  const Units& units;
  AngularSpace space;
  std::filesystem::path case_folder;
  bool beside_conductors = false;  ///< whether a medium conducts heat
};

std::map<std::string, MediumCase> read_media(Section media, const MatterContext& context);
std::map<std::string, WallCase> read_walls(Section walls, const WallContext& context);

}  // namespace etendue
