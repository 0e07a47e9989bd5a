// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;

/// Poisson's kernel: 1/(2 pi) (1 + 2 sum of g^k cos(k t)).
double poisson(double g, double mu) { return (1 - g * g) / (2 * pi * (1 + g * g - 2 * g * mu)); }

double plane_value(const PhaseIsotropic&, double) { return 1 / (2 * pi); }
double plane_value(const PhaseRayleigh&, double mu) { return (1 + mu * mu) / (3 * pi); }
double plane_value(const PhaseHenyeyGreenstein& phase, double mu) { return poisson(phase.asymmetry, mu); }
double plane_value(const PhaseCornetteShanks& phase, double mu) {
  const double g = phase.parameter;
  return 2 / (3 + g * g) * (1 + mu * mu) * poisson(g, mu);
}
double plane_value(const PhaseLegendre& phase, double mu) { return value_in_plane(phase, mu); }
double plane_value(const PhaseTable& phase, double mu) { return phase.value(mu); }

double plane_moment(const PhaseIsotropic&, int degree) { return degree == 0 ? 1 : 0; }
// (1 + cos^2 t) / (3 pi) = (1 + 2/6 cos 2t) / (2 pi)
double plane_moment(const PhaseRayleigh&, int degree) { return degree == 0 ? 1 : degree == 2 ? 1.0 / 6 : 0; }
double plane_moment(const PhaseHenyeyGreenstein& phase, int degree) {
  return std::pow(phase.asymmetry, degree);
}
// 1 + cos^2 t = 3/2 + cos(2t)/2, and cos(2t) cos(kt) = (cos((k-2) t) + cos((k+2) t)) / 2.
double plane_moment(const PhaseCornetteShanks& phase, int degree) {
  const double g = phase.parameter;
  return (3 * std::pow(g, degree) + (std::pow(g, std::abs(degree - 2)) + std::pow(g, degree + 2)) / 2) /
         (3 + g * g);
}
double plane_moment(const PhaseLegendre& phase, int degree) { return moment_of(phase, degree); }

/// Integral of cos(k t) from 0 to t.
double cosine_integral(int k, double t) { return k == 0 ? t : std::sin(k * t) / k; }

/// Between two cosines p = a + b cos t: integrals of cosines, in closed form.
double plane_moment(const PhaseTable& table, int degree) {
  const std::vector<double>&mu = table.cosines(), &p = table.values();
  double sum = 0;
  for (std::size_t i = 1; i < mu.size(); ++i) {
    const double slope = (p[i] - p[i - 1]) / (mu[i] - mu[i - 1]), constant = p[i] - slope * mu[i];
    const auto antiderivative = [&](double t) {
      return constant * cosine_integral(degree, t) +
             slope / 2 * (cosine_integral(std::abs(degree - 1), t) + cosine_integral(degree + 1, t));
    };
    sum += antiderivative(std::acos(mu[i - 1])) - antiderivative(std::acos(mu[i]));
  }
  return 2 * sum;
}

double integral(const PhasePart& part) {
  const PhaseTable* table = std::get_if<PhaseTable>(&part);
  return table ? plane_moment(*table, 0) : 1;
}

}  // namespace

PhasePlane::PhasePlane(std::vector<double> shares, std::vector<PhasePart> parts)
    : shares_(std::move(shares)), parts_(std::move(parts)) {
  for (const PhasePart& part : parts_) integrals_.push_back(integral(part));
}

double PhasePlane::value(double mu) const {
  double sum = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    sum += shares_[i] / integrals_[i] *
           std::visit([mu](const auto& part) { return plane_value(part, mu); }, parts_[i]);
  return sum;
}

double PhasePlane::moment(int degree) const {
  double sum = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    sum += shares_[i] / integrals_[i] *
           std::visit([degree](const auto& part) { return plane_moment(part, degree); }, parts_[i]);
  return sum;
}

std::string PhasePlane::name() const {
  std::string text = "in the plane: ";
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::string part = std::visit([](const auto& model) { return name_of(model); }, parts_[i]);
    text += parts_.size() == 1 ? part : fmt::format("{}{:.4g} ({})", i == 0 ? "" : " + ", shares_[i], part);
  }
  return text;
}

double value_of(const PhasePlane& phase, double mu) { return phase.value(mu); }

double moment_of(const PhasePlane& phase, int degree) { return phase.moment(degree); }

std::string name_of(const PhasePlane& phase) { return phase.name(); }

}  // namespace etendue
