// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "mesh/base/errors.h"

namespace etendue {

/// Luminous intensity over the angle from a lamp's axis, of any unit: only its shape counts.
struct LightTable {
  std::vector<double> angle;      ///< [degree] rising, from 0 to 180 at most
  std::vector<double> intensity;  ///< not negative
};

/// Reads an IES file (IESNA LM-63, photometric type C, the same in all horizontal planes) or a CSV with an
/// angle and an intensity on each line. Throws FileError or InputError; `origin` is the key that names it.
LightTable read_light_table(const std::filesystem::path& path, const Origin& origin);

}  // namespace etendue
