// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/lights/tangent_cone.h"
#include "solver/problem/problem.h"
#include "solver/solution/angular_input.h"

namespace etendue {

/// Lights that are left to the ordinates (Uncollided::no). A point shines from all of its cell, along
/// the ordinates that lead into the domain from its place, a flat light
/// from all of the cells that it lies in, by what of it is in each; a beam enters along the one ordinate that
/// is nearest to it at each face. Each sends exactly its power on any set.
class OrdinateLights : public AngularInput {
 public:
  /// The arguments must outlive it. `other` is added where it is not null.
  OrdinateLights(const Problem& problem, const DirectionSet& directions, const AngularInput* other);

  bool empty() const { return in_cells_.empty() && at_faces_.empty(); }
  bool depends_on_direction(CellIndex cell) const override;
  void add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override;
  void add_projected_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override {
    if (other_ != nullptr) other_->add_projected_source(m, cell, values);
  }
  void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const override;
  /// Adds the source of the points in a cell at any direction of travel, [vertex][band] [power/(length^3
  /// sr)].
  void add_points(const Vec3& travel, CellIndex cell, std::span<double> values) const;
  const SavedState* prescribed_state() const override {
    return other_ != nullptr ? other_->prescribed_state() : nullptr;
  }

  /// [band] What points and flat lights send [power].
  const std::vector<double>& power_inside() const { return power_inside_; }
  /// [wall][band] What beams send through walls [power]; empty without beams.
  const std::vector<std::vector<double>>& power_through_walls() const { return power_through_walls_; }

 private:
  /// What a light sends from one cell: the power of each band, and of it 1/(V sr) along each ordinate.
  struct CellPart {
    std::vector<double> power;  ///< [band]
    std::size_t shape;          ///< of shapes_
    double by_volume;           ///< [1/length^3]
  };
  /// A point light, and what its shape is divided by.
  struct PointShape {
    const PointLight* light;
    TangentCone cone;
    double integral;   ///< over the set, or over the sphere where no ordinate sees the light [sr]
    double by_volume;  ///< of the cell [1/length^3]
  };
  struct FacePart {
    std::int32_t ordinate;
    std::vector<double> radiance;  ///< [band]
  };

  void add(const PointLight& light);
  void add(const SurfaceLight& light);
  void add(const BeamLight& light);

  const Problem& problem_;
  const DirectionSet& directions_;
  const AngularInput* other_;
  std::vector<std::vector<double>> shapes_;  ///< [light][ordinate] [1/sr], of integral 1 over the set
  std::unordered_map<std::int32_t, std::vector<CellPart>> in_cells_;
  std::unordered_map<std::int32_t, std::vector<PointShape>> points_in_;
  std::unordered_map<std::int32_t, std::vector<FacePart>> at_faces_;
  std::vector<double> power_inside_;
  std::vector<std::vector<double>> power_through_walls_;
};

}  // namespace etendue
