// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;

// Nodes over 180 degrees: of smooth functions, and for each degree of a series.
constexpr std::size_t fewest_nodes = 20001, nodes_per_degree = 50;

double henyey_greenstein_cosine(double g, double u) {
  if (std::abs(g) < 1e-4) return 2 * u - 1 + 1.5 * g * (1 - (2 * u - 1) * (2 * u - 1));
  const double root = (1 - g * g) / (1 - g + 2 * g * u);
  return std::clamp((1 + g * g - root * root) / (2 * g), -1.0, 1.0);
}

template <class Parts>
std::size_t nodes_of(const Parts& phase) {
  const auto* series = std::get_if<PhaseLegendre>(&phase);
  return series != nullptr ? nodes_per_degree * series->moments.size() : 0;
}

/// As fine as the longest series asks, alone or in a mixture.
std::size_t node_count(const PhaseFunction& phase) {
  std::size_t nodes = std::max(fewest_nodes, nodes_of(phase));
  if (const auto* mixture = std::get_if<PhaseMixture>(&phase))
    for (const PhasePart& part : mixture->parts) nodes = std::max(nodes, nodes_of(part));
  return nodes;
}

}  // namespace

PhaseSampler::PhaseSampler(const PhaseFunction& phase) : phase_(phase) {
  if (std::holds_alternative<PhaseIsotropic>(phase) || std::holds_alternative<PhaseHenyeyGreenstein>(phase))
    return;
  const bool plane = std::holds_alternative<PhasePlane>(phase);
  const std::size_t count = node_count(phase);
  const double step = pi / static_cast<double>(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = pi - static_cast<double>(i) * step;
    const double ring = plane ? 2 : 2 * pi * std::abs(std::sin(angle));  // directions at this angle
    density_.push_back(std::max(0.0, ring * phase_value(phase, std::cos(angle))));
  }
  cumulative_.assign(count, 0);
  for (std::size_t i = 1; i < count; ++i)
    cumulative_[i] = cumulative_[i - 1] + step * (density_[i - 1] + density_[i]) / 2;
  for (double& value : density_) value /= cumulative_.back();
  for (double& value : cumulative_) value /= cumulative_.back();
  cumulative_.back() = 1;
}

double PhaseSampler::cosine(double u) const {
  if (std::holds_alternative<PhaseIsotropic>(phase_)) return 2 * u - 1;
  if (const auto* phase = std::get_if<PhaseHenyeyGreenstein>(&phase_))
    return henyey_greenstein_cosine(phase->asymmetry, u);
  const auto above = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, u);
  const auto i = static_cast<std::size_t>(above - cumulative_.begin());
  const double step = pi / static_cast<double>(density_.size() - 1);
  // Within the step: density d0 + (d1 - d0) t, share (d0 t + (d1 - d0) t^2 / 2) step = rest.
  const double rest = (u - cumulative_[i - 1]) / step, d0 = density_[i - 1], slope = density_[i] - d0;
  const double root = d0 + std::sqrt(std::max(0.0, d0 * d0 + 2 * slope * rest));
  const double part = root > 0 ? std::clamp(2 * rest / root, 0.0, 1.0) : 0.0;
  return std::cos(pi - (static_cast<double>(i - 1) + part) * step);
}

}  // namespace etendue
