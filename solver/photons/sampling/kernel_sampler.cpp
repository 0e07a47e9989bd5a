// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/sampling/kernel_sampler.h"

#include <algorithm>
#include <optional>

#include "solver/angular/kernels/kernel_places.h"
#include "solver/materials/kernels/kernel_formula.h"

namespace etendue {
namespace {

/// Places at which a kernel that depends on them is evaluated for its bound.
constexpr std::size_t places_looked_at = 50;
/// Draws after which light continues as it came: where the kernel was evaluated it is next to nothing.
constexpr std::int64_t most_draws = 100000;

std::vector<Vec3> places_of(const KernelFormula& kernel, bool of_product, const TetrahedralMesh& mesh,
                            int region) {
  if (of_product) return {kernel.place};
  std::vector<Vec3> all, places;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region(CellIndex(c)) == region) all.push_back(mesh.centroid(CellIndex(c)));
  const std::size_t step = std::max<std::size_t>(1, all.size() / places_looked_at);
  for (std::size_t i = 0; i < all.size(); i += step) places.push_back(all[i]);
  return places;
}

}  // namespace

KernelSampler::OwnKernel::OwnKernel(const KernelFormula& kernel) : formula(kernel_at(kernel, kernel.place)) {}

KernelSampler::KernelSampler(const KernelFormula& kernel, const TetrahedralMesh& mesh, int region)
    : mesh_(mesh),
      of_product_(kernel_places(kernel, mesh, region).empty()),
      bound_(kernel, places_of(kernel, of_product_, mesh, region)),
      pool_(OwnKernel(kernel)) {}

Vec3 KernelSampler::scattered(CellIndex cell, const Vec3& travel, DrawnNumbers& random) const {
  const CopyPool<OwnKernel>::Loan own(pool_);
  KernelFormula kernel = own->formula;
  if (!of_product_) kernel.place = mesh_.centroid(cell);
  std::int64_t draws = 0, beyond = 0;
  std::optional<Vec3> after;
  do {
    const KernelBound::Draw drawn = bound_.draw(travel, random);
    const double value = kernel.at(travel, drawn.after);
    ++draws;
    beyond += value > drawn.bound;
    if (random.number() * drawn.bound < value) after = drawn.after;
  } while (!after && of_product_ && draws < most_draws);
  draws_.fetch_add(draws, std::memory_order_relaxed);
  beyond_.fetch_add(beyond, std::memory_order_relaxed);
  return after.value_or(travel);
}

}  // namespace etendue
