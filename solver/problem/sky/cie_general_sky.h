// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/sky/sky_shape.h"

namespace etendue {

inline constexpr int cie_sky_types = 15;

/// The CIE standard general sky of a type from 1 (overcast, steep gradation) over 5 (uniform) and 12 (clear)
/// to 15 (white-blue, turbid, with a broad corona): CIE S 011/E:2003, ISO 15469:2004, table 1; Kittler, Perez
/// and Darula 1997.
SkyShape cie_general_sky(int type);

}  // namespace etendue
