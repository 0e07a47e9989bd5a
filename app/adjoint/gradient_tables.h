// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
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
  double value = 0;     ///< by the same change in all cells or faces
  double relative = 0;  ///< relative change of the response by that of the number: 0 where either is 0
};

/// Of all regions and walls, in their order. `whole` [band] is the response.
std::vector<Derivative> derivatives_of(const Gradient& gradient, const Problem& problem,
                                       const std::vector<double>& whole);

/// response,kind,name,by,band,derivative,relative
std::string gradient_csv(const std::vector<std::pair<std::string, std::vector<Derivative>>>& responses,
                         const Bands& bands);

/// For people: the largest relative changes.
std::string gradient_text(const std::vector<Derivative>& derivatives, const Bands& bands);

}  // namespace etendue
