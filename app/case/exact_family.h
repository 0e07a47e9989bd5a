// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Manufactured radiances with properties that are known beforehand, in coordinates (x - center)/length.
struct ExactFamily {
  std::string name;
  int degree = 1;  ///< of the polynomial
  Vec3 center = Vec3(0.5, 0.5, 0.5);
  double length = 1;  ///< [length]
};

/// polynomial, trigonometric, angular-exponential, jump, kink, bend
const std::vector<std::string>& exact_family_names();

/// The radiance as a formula in x, y, z, wx, wy, wz. jump, kink and bend are discontinuous, continuous and
/// once differentiable across the plane through the centre that an edge (0.36, 0.48, 0.8) and the direction
/// span, as at the border of a shadow: along the direction nothing changes.
std::string exact_formula(const ExactFamily& family);

/// Order of the L2 error of the best approximation by elements of degree `order` as the mesh is refined;
/// nothing where they hold the radiance exactly. Linear elements come up to it. Constant ones smear what
/// jumps along the ray: of `jump` they may leave 1/4, of `kink` 3/4.
std::optional<double> expected_order(const ExactFamily& family, int order);

}  // namespace etendue
