// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/case/lamps/lamp_tilt.h"

namespace etendue {

/// About which axis a lamp's planes stand and what its angles count from (LM-63): in type C and A down, in B
/// the horizontal against that of the lamp; azimuths of type C are counterclockwise seen from above, others
/// clockwise.
enum class PhotometricType { c, b, a };

/// Luminous intensity over the angle from an axis of the lamp and the azimuth about it.
struct LightTable {
  std::vector<double> angle;      ///< [degree] rising, from 0 to 180 at most
  std::vector<double> intensity;  ///< [plane][angle] not negative
  std::vector<double> plane;      ///< [degree] rising, one turn at most; empty: one plane for all
  PhotometricType type = PhotometricType::c;
  /// What 1 of `intensity` is [cd]; empty: the unit is not known, and only the shape counts.
  std::optional<double> candelas;
  LampTilt tilt;  ///< of the candelas
};

/// Reads an IES file, an EULUMDAT file (.ldt) or a CSV with an angle and an intensity on each line, or an
/// angle, an azimuth and an intensity. The file must be one that opens. Throws FileError or InputError.
LightTable read_light_table(const std::filesystem::path& path);

}  // namespace etendue
