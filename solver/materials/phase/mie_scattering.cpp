// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/mie_scattering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/quadrature/gauss_legendre.h"
#include "solver/materials/phase/mie_sphere.h"

namespace etendue {
namespace {

using std::numbers::pi;

// Beyond, the series take minutes; geometric optics describes such spheres.
constexpr double largest_size_parameter = 3000;
// Steps of ln r for each standard deviation: finer than the ripples of spheres that scatter much.
constexpr double steps_per_deviation = 40;
// Sizes whose part of the scattered light is below this are left out.
constexpr double negligible_part = 1e-9;
constexpr double negligible_moment = 1e-13;

/// A distribution over u = ln r: its density r n(r), where r^2 times it is largest, and its width.
struct Distribution {
  double center = 0;
  double deviation = 0;  ///< 0: one size
  Sizes sizes;

  double log_density(double u) const {
    if (const auto* normal = std::get_if<LogNormalSizes>(&sizes)) {
      const double distance = (u - std::log(normal->median)) / std::log(normal->deviation);
      return -distance * distance / 2 - std::log(std::sqrt(2 * pi) * std::log(normal->deviation));
    }
    const auto* gamma = std::get_if<GammaSizes>(&sizes);
    if (gamma == nullptr) return 0;
    const double v = gamma->variance, shape = (1 - 2 * v) / v, scaled = u - std::log(gamma->effective * v);
    return shape * scaled - std::exp(scaled) - std::lgamma(shape);
  }
};

Distribution distribution_of(const Sizes& sizes) {
  if (const auto* normal = std::get_if<LogNormalSizes>(&sizes)) {
    const double width = std::log(normal->deviation);
    return {std::log(normal->median) + 2 * width * width, width, sizes};
  }
  if (const auto* gamma = std::get_if<GammaSizes>(&sizes))
    return {std::log(gamma->effective), std::sqrt(gamma->variance), sizes};
  return {std::log(std::get<OneSize>(sizes).radius), 0, sizes};
}

/// One size of the sum.
struct SizeClass {
  double radius;
  double weight;  ///< share of the spheres; those too small to matter are left out
  MieSphere sphere;
};

double scattered(const SizeClass& size) {
  return size.weight * size.radius * size.radius * size.sphere.scattering();
}

std::vector<SizeClass> size_classes(const Sizes& sizes, std::complex<double> index, double wavelength) {
  const Distribution distribution = distribution_of(sizes);
  const double step = distribution.deviation > 0 ? distribution.deviation / steps_per_deviation : 1;
  const auto at = [&](double u) -> SizeClass {
    const double radius = std::exp(u);
    return {radius, step * std::exp(distribution.log_density(u)),
            MieSphere(2 * pi * radius / wavelength, index)};
  };
  std::vector<SizeClass> classes = {at(distribution.center)};
  double largest = scattered(classes.front());
  if (distribution.deviation > 0)
    for (const double sign : {1.0, -1.0})
      for (int i = 1;; ++i) {
        classes.push_back(at(distribution.center + sign * i * step));
        const double part = scattered(classes.back());
        largest = std::max(largest, part);
        if (part < negligible_part * largest) break;
      }
  return classes;
}

/// Legendre moments of the mean intensity. It is a polynomial of degree 2 terms, and P_l times it at most
/// twice that: Gauss's rule is exact.
PhaseLegendre moments_of(const std::vector<SizeClass>& classes) {
  int terms = 0;
  for (const SizeClass& size : classes) terms = std::max(terms, size.sphere.terms());
  const GaussRule rule = gauss_legendre(2 * terms + 1);
  const auto degrees = static_cast<std::size_t>(2 * terms + 1);
  std::vector<double> moments(degrees, 0.0);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    double intensity = 0;
    for (const SizeClass& size : classes) intensity += size.weight * size.sphere.intensity(rule.nodes[i]);
    const double weighted = rule.weights[i] * intensity, mu = rule.nodes[i];
    double before = 0, polynomial = 1;
    for (std::size_t l = 0; l < degrees; ++l) {
      moments[l] += weighted * polynomial;
      const double order = static_cast<double>(l);
      const double next = ((2 * order + 1) * mu * polynomial - order * before) / (order + 1);
      before = std::exchange(polynomial, next);
    }
  }
  const double integral = moments[0];
  for (double& moment : moments) moment /= integral;
  while (moments.size() > 1 && std::abs(moments.back()) < negligible_moment) moments.pop_back();
  return {moments};
}

double largest_radius(const Sizes& sizes) {
  if (const auto* normal = std::get_if<LogNormalSizes>(&sizes)) {
    const double width = std::log(normal->deviation);
    return normal->median * std::exp(2 * width * width + 6.5 * width);
  }
  if (const auto* gamma = std::get_if<GammaSizes>(&sizes))
    return gamma->effective * (1 + 12 * std::sqrt(gamma->variance));
  return std::get<OneSize>(sizes).radius;
}

}  // namespace

std::string mie_problem(const Sizes& sizes, std::complex<double> index, double wavelength) {
  if (index == 1.0) return "index = 1 scatters nothing; use a refractive index other than that outside";
  const double size_parameter = 2 * pi * largest_radius(sizes) / wavelength;
  if (size_parameter > largest_size_parameter)
    return fmt::format(
        "spheres of up to 2 pi radius / wavelength = {:.3g} are too large (the series take too long); use at "
        "most {:g}, a narrower distribution, or a table from geometric optics",
        size_parameter, largest_size_parameter);
  return {};
}

MieScattering mie_scattering(const Sizes& sizes, std::complex<double> index, double wavelength) {
  const std::vector<SizeClass> classes = size_classes(sizes, index, wavelength);
  MieScattering result;
  for (const SizeClass& size : classes) {
    const double area = size.weight * pi * size.radius * size.radius;
    result.area += area;
    result.extinction_cross_section += area * size.sphere.extinction();
    result.scattering_cross_section += area * size.sphere.scattering();
  }
  result.phase = moments_of(classes);
  return result;
}

}  // namespace etendue
