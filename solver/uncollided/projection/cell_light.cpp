// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/cell_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mesh/tetrahedra/corners.h"
#include "solver/uncollided/projection/arriving_light.h"
#include "solver/uncollided/projection/ray_segment.h"

namespace etendue {
namespace {

/// A cell as far away as so many of its sizes, no thicker than this and in which a medium leaves no
/// more of the light at one point than at another but for a factor is seen from four points.
constexpr double far_in_cell_sizes = 8. / 3, thin_cell = 0.3, even_cell_factor = 1.2;
/// How often a cell with a shadow's edge is divided in eight.
constexpr int most_cell_divisions = 2;

/// Moments of the same kind.
NodalMoments none_of(const NodalMoments& moments) {
  NodalMoments none = moments;
  none.clear();
  return none;
}

class PointsOfCell {
 public:
  PointsOfCell(const LightPaths& paths, const LightSource& source, const LitCell& cell, LightBeams& beams,
               NodalMoments& moments)
      : matter_(paths.matter()),
        source_(source),
        cell_(cell),
        beams_(beams),
        moments_(moments),
        clear_(beams.bands()),
        transmittance_(beams.bands()),
        none_(beams.bands(), 0) {}

  /// False, and nothing is added, where the light is so uneven that four points see it badly, unless any will
  /// do.
  bool add(bool any) {
    NodalMoments sum = none_of(moments_);
    const Seen seen = add_points(whole_cell(), cell_.volume, sum);
    if (seen.in_part)
      add_parts(whole_cell(), cell_.volume, most_cell_divisions);
    else if (any || seen.evenly)
      moments_.add(sum);
    return any || seen.in_part || seen.evenly;
  }

 private:
  struct Seen {
    bool in_part;  ///< by some of the points
    bool evenly;
  };
  Seen add_points(const SubTetrahedron& part, double measure, NodalMoments& sum) {
    std::size_t fewest = SIZE_MAX, most = 0;
    transmittance_.clear();
    for (const CellPointWeight& point : four_point_rule()) {
      const std::size_t count = add_point(in_whole(point.barycentric, part), point.weight * measure, sum);
      fewest = std::min(fewest, count);
      most = std::max(most, count);
    }
    return {fewest != most, transmittance_.is_even(even_cell_factor, none_)};
  }
  void add_parts(const SubTetrahedron& whole, double measure, int divisions) {
    for (const SubTetrahedron& part : equal_parts(whole)) {
      NodalMoments sum = none_of(moments_);
      if (add_points(part, measure / 8, sum).in_part && divisions > 1)
        add_parts(part, measure / 8, divisions - 1);
      else
        moments_.add(sum);
    }
  }
  /// How many beams reach the point.
  std::size_t add_point(const std::array<double, 4>& barycentric, double measure, NodalMoments& sum) {
    beams_.clear();
    source_.add_beams({cell_.index, cell_.position(barycentric)}, Sight::attenuated, coarse_light, beams_);
    for (std::size_t i = 0; i < beams_.size(); ++i) {
      sum.add(barycentric, measure, beams_.direction(i), beams_.fluence(i));
      add_losses_of(i, barycentric, measure, sum);
    }
    add_transmittance(cell_.position(barycentric));
    return beams_.size();
  }
  /// Transmitted fraction of the light that would arrive in empty space.
  void add_transmittance(const Vec3& position) {
    clear_.clear();
    source_.add_beams({cell_.index, position}, Sight::clear, coarse_light, clear_);
    const std::span<double> part = transmittance_.add();
    for (std::size_t b = 0; b < part.size(); ++b) {
      double all = 0;
      for (std::size_t i = 0; i < beams_.size(); ++i) part[b] += beams_.fluence(i)[b];
      for (std::size_t i = 0; i < clear_.size(); ++i) all += clear_.fluence(i)[b];
      if (all > 0) part[b] /= all;
    }
  }
  void add_losses_of(std::size_t beam, const std::array<double, 4>& barycentric, double measure,
                     NodalMoments& sum) {
    if (sum.components() <= NodalMoments::collided && sum.by_direction() == nullptr) return;
    const Vec3& direction = beams_.direction(beam);
    const RayMatter::View view = matter_.empty() ? RayMatter::View{} : matter_.view(direction);
    for (std::size_t b = 0; b < beams_.bands(); ++b) {
      const PathCoefficients here = matter_.at(cell_.index, b, view, cell_.position(barycentric));
      const double fluence = beams_.fluence(beam)[b];
      add_losses(barycentric, measure, here, b, fluence, sum);
      sum.add_scattered(direction, barycentric, b, measure * here.scattering * fluence);
    }
  }

  const RayMatter& matter_;
  const LightSource& source_;
  const LitCell& cell_;
  LightBeams& beams_;
  NodalMoments& moments_;
  LightBeams clear_;
  ArrivingLight transmittance_;
  std::vector<double> none_;  ///< [band]
};

}  // namespace

LitCell::LitCell(const LightPaths& paths, CellIndex cell)
    : index(cell),
      corners(corners_of(paths.problem().mesh(), cell)),
      volume(paths.problem().mesh().volume(cell)),
      centroid(paths.problem().mesh().centroid(cell)) {
  size = std::cbrt(6 * std::sqrt(2.0) * volume);
  thickness = paths.largest_extinction(cell) * size;
}

void add_directly(const LightPaths& paths, const LightSource& source, const ShadowPlanes& shadows,
                  const LitCell& cell, LightBeams& beams, NodalMoments& moments) {
  const bool far = !source.is_near(cell.centroid, far_in_cell_sizes * cell.size);
  // Between parallel mirrors suns from both sides make up for what each misses, if both are seen alike.
  if (far && cell.thickness <= thin_cell && !shadows.pass_through(cell.corners) &&
      PointsOfCell(paths, source, cell, beams, moments).add(!shadows.are_complete()))
    return;
  if (source.as_point() != nullptr)
    add_in_polar_frame(paths, *source.as_point(), shadows, cell, moments);
  else
    add_in_columns(paths, *source.as_beam(), shadows, cell, moments);
}

}  // namespace etendue
