// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Of steps in time, of second order in the step and L-stable, so that long steps damp what changes fast;
/// behind sharp fronts both leave ripples. Two solutions a step (Alexander 1977, the singly diagonally
/// implicit method with gamma = 1 - 1/sqrt(2)), or one (backward differentiation, which begins with a step of
/// the other).
enum class StepMethod { sdirk2, bdf2 };

}  // namespace etendue
