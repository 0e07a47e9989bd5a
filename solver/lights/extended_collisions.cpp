// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/extended_collisions.h"

#include <algorithm>

#include "solver/problem/cell_rule.h"

namespace etendue {
namespace {

/// Cells that are nearer to a light than so many of their sizes are sampled at fourteen points, others at
/// four.
constexpr double near_in_sizes = 4;
/// The length of the mean direction below which light comes from so many directions that a coarse grid tells
/// them apart.
constexpr double wide = 0.96;

/// The light that rays find, by direction.
class FoundLight {
 public:
  FoundLight(const LightPaths& paths, const LightSource& source, const LitCell& cell, LightBeams& beams,
             DirectionalMoments& found)
      : paths_(paths), source_(source), cell_(cell), beams_(beams), found_(found) {}

  template <class Rule>
  void look(const Rule& rule, Sight sight) {
    found_.clear();
    bool first = true;
    for (const auto& point : rule) {
      beams_.clear();
      source_.add_beams({cell_.index, cell_.position(point.barycentric)}, sight, coarse_light, beams_);
      if (first && beams_.size() > 0) {
        found_.set_detail(is_wide() ? AngularDetail::coarse : AngularDetail::medium);
        first = false;
      }
      for (std::size_t k = 0; k < beams_.size(); ++k) add_beam(k, point.barycentric, point.weight);
    }
  }

  /// [4][band] the sums over the directions.
  std::vector<double> sums() const {
    std::vector<double> sums(4 * beams_.bands(), 0);
    for (std::size_t k = 0; k < found_.found().size(); ++k)
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += found_.values(k)[i];
    return sums;
  }

 private:
  bool is_wide() const {
    double sum = 0;
    Vec3 mean = Vec3::Zero();
    for (std::size_t k = 0; k < beams_.size(); ++k)
      for (const double fluence : beams_.fluence(k)) {
        sum += fluence;
        mean += fluence * beams_.direction(k);
      }
    return mean.norm() < wide * sum;
  }
  void add_beam(std::size_t k, const std::array<double, 4>& barycentric, double weight) {
    const Vec3& direction = beams_.direction(k);
    const RayMatter& matter = paths_.matter();
    const RayMatter::View view = matter.empty() ? RayMatter::View{} : matter.view(direction);
    for (std::size_t b = 0; b < beams_.bands(); ++b)
      found_.add(direction, barycentric, b,
                 weight * beams_.fluence(k)[b] *
                     matter.at(cell_.index, b, view, cell_.position(barycentric)).scattering);
  }

  const LightPaths& paths_;
  const LightSource& source_;
  const LitCell& cell_;
  LightBeams& beams_;
  DirectionalMoments& found_;
};

bool any_missing(std::span<const double> power, const std::vector<double>& sums) {
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (power[i] > 0 && !(sums[i] > 0)) return true;
  return false;
}

}  // namespace

void add_extended_collisions(const LightPaths& paths, const LightSource& source, const LitCell& cell,
                             std::span<const double> power, LightBeams& beams, DirectionalMoments& sum) {
  FoundLight found(paths, source, cell, beams, sum);
  const auto look = [&](Sight sight) {
    if (source.is_near(cell.centroid, near_in_sizes * cell.size))
      found.look(cell_rule(), sight);
    else
      found.look(four_point_rule(), sight);
  };
  look(Sight::attenuated);
  std::vector<double> sums = found.sums();
  if (any_missing(power, sums)) {
    look(Sight::clear);
    sums = found.sums();
  }
  for (std::size_t k = 0; k < sum.found().size(); ++k) {
    const std::span<double> values = sum.values(k);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] *= sums[i] > 0 ? power[i] / sums[i] : 0;
  }
}

}  // namespace etendue
