// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/refraction/refraction_weights.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "solver/angular/refraction/polar_levels.h"
#include "solver/problem/mirror.h"

namespace etendue {
namespace {

using std::numbers::pi;

constexpr double smallest_factor = 0.2;
/// Residual of conditions, relative to their norm, above which they contradict each other.
constexpr double unmatched = 1e-11;

/// Groups of ordinates whose weights stay equal: opposites, and images at planes that keep the set.
class Orbits {
 public:
  Orbits(const DirectionSet& set, const std::vector<Vec3>& mirrors)
      : of_(static_cast<std::size_t>(set.count())) {
    std::iota(of_.begin(), of_.end(), 0);
    for (int m = 0; m < set.count(); m += 2) join(m, m + 1);
    for (const Vec3& normal : mirrors)
      for (int m = 0; m < set.count(); ++m) join(m, set.mirrored(OrdinateIndex(m), normal));
    std::vector<int> number(of_.size(), -1);
    int count = 0;
    for (int m = 0; m < set.count(); ++m) {
      int& orbit = number[static_cast<std::size_t>(root(m))];
      if (orbit < 0) orbit = count++;
    }
    for (int m = 0; m < set.count(); ++m) of_orbit_.push_back(number[static_cast<std::size_t>(root(m))]);
    weights_.setZero(count);
    for (std::size_t m = 0; m < of_orbit_.size(); ++m) weights_[of_orbit_[m]] += set.weights()[m];
  }

  const Eigen::VectorXd& weights() const { return weights_; }  ///< [orbit] [sr]
  int of(std::size_t ordinate) const { return of_orbit_[ordinate]; }

 private:
  int root(int m) const {
    while (of_[static_cast<std::size_t>(m)] != m) m = of_[static_cast<std::size_t>(m)];
    return m;
  }
  void join(int a, int b) {
    if (b < 0) return;
    const int first = root(a), second = root(b);
    of_[static_cast<std::size_t>(std::max(first, second))] = std::min(first, second);
  }

  std::vector<int> of_;        ///< [ordinate] another of the same orbit, or itself
  std::vector<int> of_orbit_;  ///< [ordinate]
  Eigen::VectorXd weights_;
};

/// The cone of directions that a refracting plane lets through, and the edge between ordinates inside and
/// outside.
struct Cone {
  Vec3 normal;
  double critical;  ///< cosine of the critical angle
  double edge;      ///< cosine between the last ordinate in the cone and the first outside
};

/// Moments that weights are to have: [condition] the integral of a function over the sphere.
class Conditions {
 public:
  Conditions(const DirectionSet& set, const Orbits& orbits) : set_(&set), orbits_(&orbits) {}

  /// The moment of a function of the direction becomes `integral`, or keeps its value without one.
  template <class Function>
  void add(const Function& function, std::optional<double> integral) {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(orbits_->weights().size());
    for (std::size_t m = 0; m < set_->weights().size(); ++m)
      sums[orbits_->of(m)] += set_->weights()[m] * function(set_->directions()[m]);
    targets_.push_back(integral.value_or(sums.sum()));
    sums_.push_back(std::move(sums));
  }

  void add_sphere(int degree) {
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b)
        add(
            [=](const Vec3& w) {
              return std::pow(w.x(), a) * std::pow(w.y(), b) * std::pow(w.z(), degree - a - b);
            },
            std::nullopt);
  }

  /// Moments of |w.n| in the cone and outside of it.
  void add_cone(const Cone& cone, int degree) {
    const auto moment = [&](bool inside) {
      return [&cone, degree, inside](const Vec3& w) {
        const double cosine = std::abs(w.dot(cone.normal));
        return (cosine > cone.edge) == inside ? std::pow(cosine, degree) : 0;
      };
    };
    const double outside = std::pow(cone.critical, degree + 1);
    add(moment(true), 4 * pi * (1 - outside) / (degree + 1));
    if (cone.critical > 0) add(moment(false), 4 * pi * outside / (degree + 1));
  }

  /// [orbit] The factors nearest to 1 that meet the conditions; empty where they contradict each other or
  /// take a factor that is too small.
  std::optional<Eigen::VectorXd> factors() const {
    const Eigen::VectorXd roots = orbits_->weights().cwiseSqrt();
    Eigen::MatrixXd matrix(sums_.size(), roots.size());
    Eigen::VectorXd excess(sums_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const Eigen::VectorXd scaled = sums_[i].cwiseQuotient(roots);
      const double scale = std::max(scaled.norm(), 1e-3);
      matrix.row(row) = scaled / scale;
      excess[row] = (targets_[i] - sums_[i].sum()) / scale;
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-9);
    solver.compute(matrix);
    Eigen::VectorXd change = solver.solve(excess);
    change += solver.solve(excess - matrix * change);
    if ((excess - matrix * change).cwiseAbs().maxCoeff() > unmatched) return std::nullopt;
    Eigen::VectorXd factors = (change.cwiseQuotient(roots).array() + 1).matrix();
    if (factors.minCoeff() < smallest_factor) return std::nullopt;
    return factors;
  }

 private:
  const DirectionSet* set_;
  const Orbits* orbits_;
  std::vector<Eigen::VectorXd> sums_;  ///< [condition][orbit] of w times the function
  std::vector<double> targets_;        ///< [condition]
};

/// The conditions that hold whatever refracts. The half range along an axis that is a normal of a cone is
/// made exact with the cone's moments.
Conditions common_conditions(const DirectionSet& set, const Orbits& orbits,
                             const std::vector<SmoothPlane>& planes) {
  Conditions conditions(set, orbits);
  conditions.add_sphere(2);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 unit = Vec3::Unit(axis);
    if (std::ranges::none_of(planes,
                             [&](const SmoothPlane& p) { return p.normal.cross(unit).norm() < 1e-10; }))
      conditions.add([axis](const Vec3& w) { return std::abs(w[axis]); }, std::nullopt);
  }
  return conditions;
}

/// The ways to part the ordinates at a plane's critical angle whose solid angles are nearest to the cone's,
/// nearest first.
std::vector<Cone> possible_cones(const DirectionSet& set, const SmoothPlane& plane) {
  constexpr std::size_t most = 4;
  const double critical = critical_cosine(plane.refractive_index);
  if (critical == 0) return {{plane.normal, 0, -1}};
  const PolarLevels levels(set, plane.normal);
  std::vector<std::pair<double, Cone>> found;
  double inside = 0;
  for (std::size_t i = 0; i + 1 < levels.levels().size(); ++i) {
    inside += levels.levels()[i].weight / (4 * pi);
    const double edge = (levels.levels()[i].cosine + levels.levels()[i + 1].cosine) / 2;
    found.push_back({std::abs(inside - (1 - critical)), {plane.normal, critical, edge}});
  }
  std::ranges::stable_sort(found, {}, &std::pair<double, Cone>::first);
  std::vector<Cone> cones;
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i) cones.push_back(found[i].second);
  return cones;
}

/// The cone whose moments of degree 0 and 1, beside the other conditions, change the weights least; empty
/// where none can have them.
std::optional<Cone> easiest_cone(const DirectionSet& set, const Orbits& orbits, const Conditions& others,
                                 const SmoothPlane& plane) {
  std::optional<Cone> best;
  double least = HUGE_VAL;
  for (const Cone& cone : possible_cones(set, plane)) {
    Conditions conditions = others;
    for (const int degree : {0, 1}) conditions.add_cone(cone, degree);
    const std::optional<Eigen::VectorXd> factors = conditions.factors();
    if (!factors) continue;
    const double change = orbits.weights().dot((factors->array() - 1).square().matrix());
    if (change >= least) continue;
    least = change;
    best = cone;
  }
  return best;
}

/// Planes that take every ordinate of a set to another, or to itself.
std::vector<Vec3> planes_of_symmetry(const DirectionSet& set, std::span<const SmoothPlane> planes) {
  std::vector<Vec3> normals = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  for (const SmoothPlane& plane : planes) normals.push_back(plane.normal);
  std::erase_if(normals, [&](const Vec3& normal) {
    for (int m = 0; m < set.count(); ++m)
      if (set.mirrored(OrdinateIndex(m), normal) < 0) return true;
    return false;
  });
  return normals;
}

}  // namespace

DirectionSet fitted_to_refraction(const DirectionSet& set, std::span<const SmoothPlane> planes) {
  const std::vector<Vec3> mirrors = planes_of_symmetry(set, planes);
  std::vector<SmoothPlane> refracting;
  for (const SmoothPlane& plane : planes)
    if (plane.refractive_index != 1 && std::ranges::find(mirrors, plane.normal) != mirrors.end())
      refracting.push_back(plane);
  if (refracting.empty()) return set;
  const Orbits orbits(set, mirrors);
  Conditions conditions = common_conditions(set, orbits, refracting);
  std::vector<Cone> cones;
  for (const SmoothPlane& plane : refracting)
    if (const std::optional<Cone> cone = easiest_cone(set, orbits, conditions, plane)) {
      for (const int degree : {0, 1}) conditions.add_cone(*cone, degree);
      cones.push_back(*cone);
    }
  if (cones.empty()) return set;
  const auto add_if_possible = [&conditions](const auto& add) {
    Conditions more = conditions;
    add(more);
    if (more.factors()) conditions = more;
  };
  add_if_possible([](Conditions& more) { more.add_sphere(4); });
  add_if_possible([&](Conditions& more) {
    for (const Cone& cone : cones) more.add_cone(cone, 2);
  });
  const Eigen::VectorXd factors = conditions.factors().value();
  std::vector<double> weights(set.weights().begin(), set.weights().end());
  for (std::size_t m = 0; m < weights.size(); ++m) weights[m] *= factors[orbits.of(m)];
  return DirectionSet(set.name(), set.order(), {set.directions().begin(), set.directions().end()}, weights);
}

bool parts_at_critical_angle(const DirectionSet& set, const SmoothPlane& plane) {
  constexpr double same_flux = 1e-6;  // relative
  const double critical = critical_cosine(plane.refractive_index);
  if (critical == 0) return true;
  const PolarLevels levels(set, plane.normal);
  double flux = 0;
  for (const PolarLevel& level : levels.levels()) {
    flux += level.weight * level.cosine / (2 * pi);
    if (std::abs(flux - (1 - critical * critical)) < same_flux) return true;
  }
  return false;
}

}  // namespace etendue
