// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/radiosity/patches/patch_tree.h"

namespace etendue {

/// Exchange of two nodes with nothing between them: the kernel k = cos cos/(pi r^2) [1/length^2], 0 behind
/// a horizon, fitted between their samples by
///
///     k(x, y) = mean + slope_a.(x - centre of a) + slope_b.(y - centre of b)
///
/// A node of one patch has no slope: all on a patch is even.
struct NodeKernel {
  double mean = 0;  ///< weighted by areas: G = mean A_a A_b
  Vec3 slope_a = Vec3::Zero(), slope_b = Vec3::Zero();
  double residual = 0;   ///< largest deviation from the fit
  double variation = 0;  ///< half of what the largest and the smallest between samples differ by
};
NodeKernel node_kernel(const PatchNode& a, const PatchNode& b);

/// Surely no point of one is before any patch of the other, so that they exchange nothing.
bool are_behind(const PatchNode& a, const PatchNode& b);

/// Each lies outside of a ball around the other, and looks to one side, so that samples tell what is between.
bool are_apart(const PatchNode& a, const PatchNode& b);

}  // namespace etendue
