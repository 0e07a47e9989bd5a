// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/cone_cubature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;
using Place = std::array<double, 2>;  ///< polar angle, azimuth

struct ConePatch {
  Place centre{};
  Place half{};                ///< half widths
  std::vector<double> values;  ///< integrals
  std::vector<double> errors;
  std::size_t split_along = 0;
  double worst = 0;  ///< largest error, relative to what is aimed at
};

/// Functions times the sine of the polar angle, at places of the cone.
class OnPatches {
 public:
  OnPatches(const Cone& cone, std::size_t count, const ConeFunctions& functions)
      : cone_(cone),
        across_(cone.axis.unitOrthogonal()),
        up_(cone.axis.cross(across_)),
        count_(count),
        functions_(functions) {}

  std::vector<double> at(const Place& place) const {
    std::vector<double> values(count_, 0);
    const double sine = std::sin(place[0]), cosine = std::cos(place[0]);
    functions_(cosine * cone_.axis + sine * (std::cos(place[1]) * across_ + std::sin(place[1]) * up_),
               values);
    for (double& value : values) value *= sine;
    return values;
  }
  void apply_rule(ConePatch& patch) const;

  static constexpr int points = 17;

 private:
  const Cone& cone_;
  Vec3 across_, up_;
  std::size_t count_;
  const ConeFunctions& functions_;
};

// Genz and Malik (1980), table 1, for two dimensions.
struct GenzMalik {
  static constexpr double inner = 0.35856858280031809;   ///< sqrt(9/70)
  static constexpr double outer = 0.94868329805051380;   ///< sqrt(9/10)
  static constexpr double corner = 0.68824720161168529;  ///< sqrt(9/19)
  static constexpr double w_centre = (12824. - 9120 * 2 + 400 * 4) / 19683;
  static constexpr double w_inner = 980. / 6561;
  static constexpr double w_outer = (1820. - 400 * 2) / 19683;
  static constexpr double w_diagonal = 200. / 19683;
  static constexpr double w_corner = 6859. / 19683 / 4;
  static constexpr double v_centre = (729. - 950 * 2 + 50 * 4) / 729;
  static constexpr double v_inner = 245. / 486;
  static constexpr double v_outer = (265. - 100 * 2) / 1458;
  static constexpr double v_diagonal = 25. / 729;
};

void OnPatches::apply_rule(ConePatch& patch) const {
  using R = GenzMalik;
  const double area = 4 * patch.half[0] * patch.half[1];
  patch.values.assign(count_, 0);
  patch.errors.assign(count_, 0);
  std::vector<double> low(count_, 0);
  const auto add = [&](double x, double y, double seventh, double fifth) {
    std::vector<double> f = at({patch.centre[0] + x * patch.half[0], patch.centre[1] + y * patch.half[1]});
    for (std::size_t k = 0; k < count_; ++k) {
      patch.values[k] += area * seventh * f[k];
      low[k] += area * fifth * f[k];
    }
    return f;
  };
  const std::vector<double> middle = add(0, 0, R::w_centre, R::v_centre);
  std::array<double, 2> bend{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::vector<double> fourth(count_, 0);
    for (const double sign : {-1., 1.}) {
      const double x = axis == 0 ? sign : 0, y = axis == 1 ? sign : 0;
      const auto near = add(R::inner * x, R::inner * y, R::w_inner, R::v_inner);
      const auto far = add(R::outer * x, R::outer * y, R::w_outer, R::v_outer);
      // Fourth differences: the ratio of the squared distances is 1/7.
      for (std::size_t k = 0; k < count_; ++k) fourth[k] += near[k] - middle[k] - (far[k] - middle[k]) / 7;
    }
    for (const double value : fourth) bend[axis] += std::abs(value);
  }
  for (const double x : {-1., 1.})
    for (const double y : {-1., 1.}) {
      add(R::outer * x, R::outer * y, R::w_diagonal, R::v_diagonal);
      add(R::corner * x, R::corner * y, R::w_corner, 0);
    }
  for (std::size_t k = 0; k < count_; ++k) patch.errors[k] = std::abs(patch.values[k] - low[k]);
  const bool alike = std::abs(bend[0] - bend[1]) <= 1e-3 * (bend[0] + bend[1]);
  patch.split_along = alike ? (patch.half[1] > patch.half[0] ? 1 : 0) : (bend[1] > bend[0] ? 1 : 0);
}

void weigh(ConePatch& patch, const std::vector<double>& whole) {
  patch.worst = 0;
  for (std::size_t k = 0; k < whole.size(); ++k)
    if (whole[k] != 0) patch.worst = std::max(patch.worst, patch.errors[k] / std::abs(whole[k]));
}

bool fine_enough(const ConeIntegrals& sum, double relative) {
  for (std::size_t k = 0; k < sum.values.size(); ++k)
    if (sum.errors[k] > relative * std::abs(sum.values[k])) return false;
  return true;
}

}  // namespace

double Cone::solid_angle() const {
  const double sine = std::sin(half_angle / 2);
  return 4 * pi * sine * sine;
}

double Cone::projected_solid_angle() const {
  const double sine = std::sin(half_angle);
  return pi * sine * sine;
}

bool Cone::holds(const Vec3& direction) const {
  return std::atan2(axis.cross(direction).norm(), axis.dot(direction)) <= half_angle;
}

ConeIntegrals integrate_over_cone(const Cone& cone, std::size_t count, const ConeFunctions& functions,
                                  double relative, int most, const std::function<bool()>& go_on) {
  const OnPatches rule(cone, count, functions);
  ConeIntegrals sum{std::vector<double>(count, 0), std::vector<double>(count, 0), 0};
  std::vector<ConePatch> patches;
  const auto add = [&](ConePatch patch) {
    rule.apply_rule(patch);
    sum.directions += OnPatches::points;
    patches.push_back(std::move(patch));
  };
  const auto add_up = [&] {
    std::fill(sum.values.begin(), sum.values.end(), 0.0);
    std::fill(sum.errors.begin(), sum.errors.end(), 0.0);
    for (const ConePatch& patch : patches)
      for (std::size_t k = 0; k < count; ++k) {
        sum.values[k] += patch.values[k];
        sum.errors[k] += patch.errors[k];
      }
  };
  for (int quarter = 0; quarter < 4; ++quarter)
    add({{cone.half_angle / 2, (quarter + 0.5) * pi / 2}, {cone.half_angle / 2, pi / 4}, {}, {}, 0, 0});
  add_up();
  while (!fine_enough(sum, relative) && sum.directions + 2 * OnPatches::points <= most &&
         (!go_on || go_on())) {
    for (ConePatch& patch : patches) weigh(patch, sum.values);
    const auto worst =
        std::max_element(patches.begin(), patches.end(),
                         [](const ConePatch& a, const ConePatch& b) { return a.worst < b.worst; });
    ConePatch low = *worst, high = *worst;
    const std::size_t axis = worst->split_along;
    patches.erase(worst);
    low.half[axis] /= 2;
    high.half[axis] /= 2;
    low.centre[axis] -= low.half[axis];
    high.centre[axis] += high.half[axis];
    add(std::move(low));
    add(std::move(high));
    add_up();
  }
  return sum;
}

}  // namespace etendue
