// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// What the lights of a case are read with.
struct LightContext {
  const Bands& bands;
  const Units& units;
  std::filesystem::path folder;
};

/// The [[light]] tables, and what the walls' beams say.
std::vector<LightCase> read_lights(Section& top, const LightContext& context);

/// `uncollided` of a medium or a wall.
Uncollided read_uncollided(Section& section);

/// The collimated light that enters by a wall; empty without `beam`.
std::optional<LightCase> read_beam(Section& wall, const std::string& name, const Bands& bands);

}  // namespace etendue
