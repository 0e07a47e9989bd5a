// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/media/matter_table.h"

#include <numbers>
#include <numeric>

#include "solver/angular/kernels/scattered_light.h"
#include "solver/materials/kernels/kernel_formula.h"

namespace etendue {
namespace {

constexpr double per_sphere = 1 / (4 * std::numbers::pi);

/// A copy that a thread may evaluate.
DirectionalScattering own_copy(const DirectionalScattering& scattering) {
  const auto* formula = std::get_if<KernelFormula>(&scattering);
  return formula != nullptr ? kernel_at(*formula, formula->place) : scattering;
}

}  // namespace

void tabulate_matter(const DirectionalScattering& scattering, std::span<const Vec3> incident,
                     const DirectionSet& directions, int threads, std::span<double> table) {
  const std::span<const double> weights = directions.weights();
  std::vector<DirectionalScattering> copies;
  for (int i = 0; i < threads; ++i) copies.push_back(own_copy(scattering));
  std::size_t next = 0;
#pragma omp parallel num_threads(threads)
  {
    std::size_t own = 0;
#pragma omp critical
    own = next++;
    const ScatteredLight scattered(copies[own], directions);
    std::vector<double> values(weights.size());
#pragma omp for schedule(dynamic, 16)
    for (std::size_t k = 0; k < incident.size(); ++k) {
      scattered.scatter({{incident[k], 1.0}}, values);
      const double sum = std::inner_product(values.begin(), values.end(), weights.begin(), 0.0);
      if (!(sum > 0)) continue;
      for (std::size_t m = 0; m < values.size(); ++m)
        table[m * incident.size() + k] = values[m] / sum - per_sphere;
    }
  }
}

}  // namespace etendue
