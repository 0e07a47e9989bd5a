// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/problem.h"

namespace etendue {

/// The largest reflectance or transmittance of a wall, mirrors left out.
double brightest_wall(const Problem& problem);
/// The largest albedo of a cell.
double largest_albedo(const Problem& problem);
/// Scatterings on a mean chord 4 V/S of the domain, in the band where they are most; infinite between mirrors
/// alone. Mirrors do not end a chord.
double scatterings_on_a_chord(const Problem& problem);
/// Estimate, rather too high, of how often light is scattered or reflected diffusely before it is absorbed or
/// leaves: the inverse of the smallest eigenvalue of I - T, which is 1 - albedo + 3 / (free paths across the
/// domain)^2 where light is diffuse, and 1 - reflectance in a void.
double most_returns(const Problem& problem);
/// The most of them for sweeps in single precision, whose rounding, 4e-7, makes an error as many times as
/// large. With a thousand a cycle of GMRES takes more sweeps, with a million it finds nothing.
inline constexpr double many_returns = 300;

}  // namespace etendue
