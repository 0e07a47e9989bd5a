// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/extended_collisions.h"

#include <algorithm>

#include "base/quadrature/cell_rule.h"

namespace etendue {
namespace {

/// Cells that are nearer to a light than so many of their sizes are sampled at fourteen points, others at
/// four.
constexpr double near_in_cell_sizes = 4;
/// The length of the mean direction below which light comes from so many directions that a coarse grid tells
/// them apart.
constexpr double wide_cone = 0.96;

/// The light that rays find, by direction.
class FoundLight {
 public:
  FoundLight(const LightPaths& paths, const LightSource& source, const LitCell& cell, LightBeams& beams,
             DirectionalMoments& found)
      : paths_(paths), source_(source), cell_(cell), beams_(beams), found_(found) {}

  template <class Rule>
  void sample(const Rule& rule, Sight sight) {
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
    return mean.norm() < wide_cone * sum;
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

/// Multiplies the values of each direction by factors [4][band].
void scale(const std::vector<double>& factors, DirectionalMoments& moments) {
  for (std::size_t k = 0; k < moments.found().size(); ++k) {
    const std::span<double> values = moments.values(k);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] *= factors[i];
  }
}

}  // namespace

// Where no ray finds light that the integrals have, its directions are those in empty space: of those nodes
// and bands alone.
void add_extended_collisions(const LightPaths& paths, const LightSource& source, const LitCell& cell,
                             std::span<const double> power, LightBeams& beams, DirectionalMoments& sum) {
  // Samples the light, and scales it to the power of the entries that count; returns the others.
  const auto sample = [&](Sight sight, std::vector<char> wanted, DirectionalMoments& moments) {
    FoundLight found(paths, source, cell, beams, moments);
    if (source.is_near(cell.centroid, near_in_cell_sizes * cell.size))
      found.sample(cell_rule(), sight);
    else
      found.sample(four_point_rule(), sight);
    std::vector<double> factors = found.sums();
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const bool counts = wanted[i] != 0 && factors[i] > 0;
      factors[i] = counts ? power[i] / factors[i] : 0;
      if (counts) wanted[i] = 0;
    }
    scale(factors, moments);
    return wanted;
  };
  std::vector<char> wanted(power.size());
  std::ranges::transform(power, wanted.begin(), [](double value) { return value > 0; });
  wanted = sample(Sight::attenuated, wanted, sum);
  if (std::ranges::count(wanted, 1) == 0) return;
  DirectionalMoments clear = sum;
  sample(Sight::clear, wanted, clear);
  sum.add(clear);
}

}  // namespace etendue
