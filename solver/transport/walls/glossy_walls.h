// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/problem/problem.h"
#include "solver/transport/order/sweep_slots.h"
#include "solver/transport/state/aligned_array.h"
#include "solver/transport/walls/wall_matrix.h"

namespace etendue {

/// The walls with a reflectance f_r: the radiance that arrives along each ordinate is kept, and reflected by
/// a matrix in the next sweep. Faces with one normal and one reflectance share a matrix.
class GlossyWalls {
 public:
  /// The arguments must outlive it.
  GlossyWalls(const Problem& problem, const DirectionSet& directions, const WallSlots& wall_slots, int stride,
              int face_nodes);

  bool empty() const { return faces_.empty(); }
  /// Of the radiance that arrives, [glossy face][pair of ordinates][face node][stride].
  std::size_t size() const { return faces_.size() * row_size_; }
  /// Reflects what arrived in the last sweep.
  void form(std::span<const double> arrived, int threads);
  /// Adds what is reflected into ordinate m to the inflow slots; faces that are no mirrors get `inflow`
  /// [boundary face][face node][stride] too, since nothing else wrote them.
  template <class Real>
  void add_reflected(OrdinateIndex m, std::span<const double> inflow, const SweepSlotsOf<Real>& slots) const;
  /// Writes the radiance that arrives along ordinate m to `arrived`.
  template <class Real>
  void store_arriving(OrdinateIndex m, const SweepSlotsOf<Real>& slots, std::span<double> arrived) const;
  /// Of isotropic light that arrives at a face, the part that is reflected.
  double albedo(FaceIndex face, std::size_t band) const;
  /// Adds a radiance to all that arrives at a face, at each of its nodes, in one band.
  void add_arriving(FaceIndex face, std::size_t band, std::span<const double> radiance,
                    std::span<double> arrived) const;
  /// What was done to the walls, wall by wall.
  std::vector<std::string> notes() const;

  /// Doubles that all matrices of a problem take, and faces that are glossy.
  struct Size {
    double matrices = 0, faces = 0;
  };
  static Size size_of(const Problem& problem, const DirectionSet& directions);

 private:
  struct Face {
    Vec3 area_normal;  ///< out of the domain [length^2]
    std::int32_t index;
    std::size_t first_matrix;  ///< in matrix_of_, one for each band
    bool is_mirror;
  };

  const Problem& problem_;
  const DirectionSet& directions_;
  const WallSlots& wall_slots_;
  std::size_t stride_, face_length_, row_size_;
  std::vector<std::unique_ptr<WallMatrix>> matrices_;
  std::vector<int> walls_of_matrices_;   ///< [matrix]
  std::vector<std::int32_t> matrix_of_;  ///< [plane and wall][band], -1: none
  std::vector<Face> faces_;
  std::vector<std::int32_t> place_of_;  ///< [boundary face] among the glossy ones, -1: none
  AlignedArray reflected_;  ///< like the radiance that arrives, of the other ordinate of each pair
};

}  // namespace etendue
