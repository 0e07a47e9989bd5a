// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// A source of glare in the view of an observer.
struct GlareSource {
  Vec3 towards;        ///< unit, to its middle
  double luminance;    ///< mean [cd/m^2]
  double solid_angle;  ///< [sr]
  double position;     ///< Guth's index
};

/// Where an observer looks.
struct LineOfSight {
  Vec3 ahead;  ///< unit
  Vec3 up;     ///< of any length, not along `ahead`
};

/// Guth's position index of a source in the direction `towards` (unit): 1 on the line of sight, greater
/// where a source disturbs less. Above the line of sight with sigma, the angle from it, and tau, the angle at
/// it from the vertical, in degrees (Levin 1975, equation 6; IES Lighting Handbook 2000, equation 9-29),
///
///     ln p = (35.2 - 0.31889 tau - 1.22 e^(-2 tau/9)) 10^-3 sigma
///            + (21 + 0.26667 tau - 0.002963 tau^2) 10^-5 sigma^2;
///
/// below it p = 1 + 0.8 R/D, from R = 0.6 D on 1 + 1.2 R/D, where D is the distance ahead and R that from the
/// line of sight (Iwata and others 1997; Einhorn 1998). As in evalglare R/D is at most 3 and p at most 16.
double guth_position_index(const LineOfSight& sight, const Vec3& towards);

/// The luminances that an observer sees, in a square picture.
struct LuminanceView {
  int across;                           ///< pixels of a side
  std::span<const Vec3> directions;     ///< [row][column] unit
  std::span<const double> solid_angle;  ///< [row][column] [sr]; 0 where nothing is seen
  std::span<const double> luminance;    ///< [row][column] [cd/m^2]
};

/// Mean luminance of a view over its solid angle [cd/m^2].
double mean_luminance(const LuminanceView& view);

/// Groups of neighboring pixels (eight around each) that `is_bright` [row][column] names, and joined where
/// their middles are less than `join` [rad] apart: their mean luminance, and their middle by luminance.
/// evalglare joins within 0.2.
std::vector<GlareSource> glare_sources(const LuminanceView& view, const std::vector<char>& is_bright,
                                       const LineOfSight& sight, double join);

/// Unified glare rating 8 lg(0.25/L_b sum of L^2 omega/p^2) (CIE 117:1995; CIE 232:2019), at least 0; 0
/// without sources. `background` is L_b, the illuminance at the eye without the sources over pi [cd/m^2].
double unified_glare_rating(std::span<const GlareSource> sources, double background);

/// Daylight glare probability 5.87e-5 E_v + 9.18e-2 lg(1 + sum of L^2 omega/(E_v^1.87 p^2)) + 0.16 (Wienold
/// and Christoffersen 2006, equation 3), at most 1, by the illuminance at the eye [lx]; with evalglare's
/// factor e^x/(1 + e^x), x = 0.024 E_v - 4, for E_v below 1000 lx. Tested between 0.2 and 0.8.
double daylight_glare_probability(std::span<const GlareSource> sources, double eye_illuminance);

}  // namespace etendue
