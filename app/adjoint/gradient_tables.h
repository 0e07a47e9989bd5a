// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/adjoint/chosen_response.h"
#include "solver/adjoint/gradient.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A derivative of a response by one number of a region or wall, in one band.
struct Derivative {
  std::string kind;  ///< "region" or "wall"
  std::string name;
  std::string by;  ///< "absorption", "scattering", "emission", "radiance" or "diffuse"
  int band = 0;
  double value = 0;  ///< by the same change in all cells or faces
  /// Relative change of the response by that of the number; empty by emission and radiance, whose shares say
  /// it.
  std::optional<double> relative = {};
};

/// Derivatives by all regions and walls, in their order, but for those whose temperature follows from the
/// light by scattering or reflection alone, and for walls that refract. `whole` [band] is the response on the
/// directions.
std::vector<Derivative> derivatives_of(const Gradient& gradient, const Problem& problem,
                                       const std::vector<double>& whole);

/// response,kind,name,by,band,derivative,relative
std::string gradient_csv(const std::vector<std::pair<std::string, std::vector<Derivative>>>& responses,
                         const Bands& bands);

/// A caution where the response on the directions alone, which the gradient is of, is another than that with
/// light along rays by more than 1 %; else empty.
std::string difference_text(const std::vector<double>& on_directions, const std::vector<double>& whole,
                            const Bands& bands);

/// For people: the largest relative changes.
std::string gradient_text(const std::vector<Derivative>& derivatives, const Bands& bands);

}  // namespace etendue
