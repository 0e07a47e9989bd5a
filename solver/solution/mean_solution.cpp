// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/mean_solution.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/vector_sums.h"
#include "solver/solution/node_means.h"

namespace etendue {
namespace {

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

/// The lists of numbers of which a mean is taken. A solution or a constant one.
template <class AnySolution>
auto fields_of(AnySolution& solution) {
  using Field = std::remove_reference_t<decltype((solution.fluence))>;
  std::vector<Field*> fields = {&solution.fluence,       &solution.net_flux,        &solution.irradiance,
                                &solution.exitance,      &solution.absorbed,        &solution.half_range,
                                &solution.meters,        &solution.source_products, &solution.state.fluence,
                                &solution.state.moments, &solution.state.irradiance};
  for (auto* powers : {&solution.by_direction.regions, &solution.by_direction.walls})
    for (auto& bands : *powers) fields.push_back(&bands);
  return fields;
}

}  // namespace

void MeanSolution::add(const Solution& solution) {
  ++count_;
  add_deviations(solution);
  if (count_ == 1) {
    sum_ = solution;
    for (const BandConvergence& band : solution.convergence) sweeps_ = std::max(sweeps_, band.sweeps);
    return;
  }
  const auto sums = fields_of(sum_);
  const auto values = fields_of(solution);
  for (std::size_t k = 0; k < sums.size(); ++k) add_to(*sums[k], *values[k]);
  add_iteration(solution);
}

// Welford (1962): mean and squared deviations without cancellation.
void MeanSolution::add_deviations(const Solution& solution) {
  const std::vector<double> values = node_means(solution.fluence, 4, solution.convergence.size());
  mean_.resize(values.size(), 0);
  deviations_.resize(mean_.size(), 0);
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    const double change = values[i] - mean_[i];
    mean_[i] += change / count_;
    deviations_[i] += change * (values[i] - mean_[i]);
  }
}

void MeanSolution::add_iteration(const Solution& solution) {
  int longest = 0;
  for (std::size_t b = 0; b < sum_.convergence.size(); ++b) {
    BandConvergence& band = sum_.convergence[b];
    const BandConvergence& other = solution.convergence[b];
    longest = std::max(longest, other.sweeps);
    band = {band.sweeps + other.sweeps, std::max(band.residual, other.residual),
            band.converged && other.converged};
  }
  for (HistoryEntry entry : solution.history) {
    entry.sweep += sweeps_;
    sum_.history.push_back(entry);
  }
  sweeps_ += longest;
  for (OrdinateFixup fixup : solution.fixups) {
    fixup.ordinate += (count_ - 1) * solution.directions;
    sum_.fixups.push_back(fixup);
  }
  for (std::size_t k = 0; k < sum_.kernels.size(); ++k)
    sum_.kernels[k].energy_error = std::max(sum_.kernels[k].energy_error, solution.kernels[k].energy_error);
  SolveSeconds& seconds = sum_.seconds;
  seconds.orders += solution.seconds.orders;
  seconds.sweep += solution.seconds.sweep;
  seconds.low_order += solution.seconds.low_order;
  seconds.low_order_setup += solution.seconds.low_order_setup;
  seconds.lights += solution.seconds.lights;
  seconds.setup += solution.seconds.setup;
  sum_.lagged_faces += solution.lagged_faces;
  sum_.sweep_cost += solution.sweep_cost;
  sum_.interrupted = sum_.interrupted || solution.interrupted;
}

Solution MeanSolution::take() && {
  const double share = 1.0 / count_;
  for (std::vector<double>* field : fields_of(sum_)) scale(*field, share);
  for (OrdinateFixup& fixup : sum_.fixups) fixup.weight *= share;
  sum_.sweep_cost *= share;
  sum_.negative = negative_census(sum_.fluence, sum_.convergence.size());
  if (count_ > 1) {
    sum_.direction_error = std::move(deviations_);
    for (double& value : sum_.direction_error) value = std::sqrt(value * share / (count_ - 1));
  }
  return std::move(sum_);
}

}  // namespace etendue
