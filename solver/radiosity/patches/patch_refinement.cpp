// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/patches/patch_refinement.h"

#include <algorithm>
#include <cmath>

#include "solver/radiosity/patches/patch_neighbours.h"

namespace etendue {
namespace {

// A neighbour that is so many times as large as a patch that is cut is cut too: those of a size are powers of
// two apart, faces of a mesh anything, and they shall not all follow each other.
constexpr double too_large = 1.5;
// Sizes are halves of halves.
constexpr double size_rounding = 1e-6;

/// [band] mean over all walls.
std::vector<double> means(const WallPatches& patches, const std::vector<double>& values, std::size_t bands) {
  std::vector<double> mean(bands, 0);
  double area = 0;
  for (std::size_t p = 0; p < patches.patches.size(); ++p) {
    area += patches.patches[p].area();
    for (std::size_t b = 0; b < bands; ++b) mean[b] += patches.patches[p].area() * values[p * bands + b];
  }
  for (double& value : mean) value /= area;
  return mean;
}

using Neighbours = std::vector<std::vector<std::size_t>>;

/// Until none that stays is more than twice too_large for what a neighbour becomes.
void grade(const WallPatches& patches, const Neighbours& neighbours, std::vector<bool>& cut) {
  std::vector<std::size_t> open;
  for (std::size_t p = 0; p < cut.size(); ++p)
    if (cut[p]) open.push_back(p);
  while (!open.empty()) {
    const std::size_t p = open.back();
    open.pop_back();
    for (const std::size_t q : neighbours[p])
      if (!cut[q] && patches.sizes[q] > too_large * patches.sizes[p]) {
        cut[q] = true;
        open.push_back(q);
      }
  }
}

}  // namespace

std::vector<bool> patches_to_cut(const TetrahedralMesh& mesh, const WallPatches& patches,
                                 const std::vector<double>& irradiance, const RefinementRule& rule) {
  const std::size_t count = patches.patches.size(), bands = irradiance.size() / count;
  std::vector<bool> cut(count, false);
  if (rule.change <= 0) return cut;
  const std::vector<double> mean = means(patches, irradiance, bands);
  const Neighbours neighbours = patch_neighbours(mesh, patches);
  const auto change = [&](std::size_t p, std::size_t q) {
    double largest = 0;
    for (std::size_t b = 0; b < bands; ++b)
      if (mean[b] > 0)
        largest =
            std::max(largest, std::abs(irradiance[p * bands + b] - irradiance[q * bands + b]) / mean[b]);
    return largest;
  };
  for (std::size_t p = 0; p < count; ++p)
    cut[p] = patches.sizes[p] > rule.smallest * (1 + size_rounding) &&
             std::ranges::any_of(neighbours[p], [&](std::size_t q) { return change(p, q) > rule.change; });
  grade(patches, neighbours, cut);
  return cut;
}

}  // namespace etendue
