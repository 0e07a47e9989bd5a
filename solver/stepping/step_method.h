// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <numbers>

namespace etendue {

/// Of steps in time, of second order in the step and L-stable, so that long steps damp what changes fast;
/// behind sharp fronts both leave ripples. Two solutions a step (Alexander 1977, the singly diagonally
/// implicit method with gamma = 1 - 1/sqrt(2)), or one (backward differentiation, which begins with a step of
/// the other).
enum class StepMethod { sdirk2, bdf2 };

/// gamma: the first stage of sdirk2 ends there, and both are as long, in steps.
inline constexpr double sdirk_gamma = 1 - 1 / std::numbers::sqrt2;
/// Length of the stage of backward differentiation, in steps: (3 u_{k+1} - 4 u_k + u_{k-1}) / (2 step) = f is
/// u_{k+1} = (4 u_k - u_{k-1})/3
/// + bdf2_part step f.
inline constexpr double bdf2_part = 2.0 / 3;

}  // namespace etendue
