// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/observe/color/band_color.h"

namespace etendue {

/// How brightness is brought into the range of a display: clipped; luminance by Reinhard et al. (2002), Y (1
/// + Y/16)/(1 + Y), so that 4 is white; or each primary by Narkowicz's (2015) fit to the filmic curve of
/// ACES.
enum class Tone { linear, reinhard, aces };

/// Of a color that was multiplied by the exposure; values from 0 to 1. A color that sRGB does not have is
/// mixed with grey of its luminance until it does.
LinearColor toned(const LinearColor& color, Tone tone);

/// The exposure with which 95 % of these colors that are not black are below white.
double automatic_exposure(std::span<const LinearColor> colors);

}  // namespace etendue
