// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <unordered_map>

#include "solver/adjoint/response.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/solution/angular_input.h"

namespace etendue {

/// A response as the source of its importance, with all directions reversed: at ordinate m the functional
/// that takes the radiance of ordinate -m. Its integrals with the basis functions are those of the response,
/// so that products with it give the response of the elements to rounding.
class ResponseSource : public AngularInput {
 public:
  /// The arguments must outlive it.
  ResponseSource(const Problem& problem, const DirectionSet& directions, const Response& response);

  bool depends_on_direction(CellIndex cell) const override;
  void add_source(OrdinateIndex, CellIndex, std::span<double>) const override {}
  void add_projected_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override;
  void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const override;

 private:
  /// Adds the linear functions whose product with a field is its value at a point, times a weight.
  void add_point(const std::vector<CellPoint>& cells, double weight);

  const Problem& problem_;
  const DirectionSet& directions_;
  const Response& response_;
  std::unordered_map<std::int32_t, std::array<double, 4>> points_;  ///< [cell][vertex] [1/length^3]
};

}  // namespace etendue
