// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/kernels/kernel_places.h"

#include <cmath>
#include <map>
#include <utility>

#include "solver/angular/sets/direction_set.h"

namespace etendue {
namespace {

/// How near a product of a factor of the place and one of the directions a formula must be to be one.
constexpr double product_agreement = 1e-9;

bool varies(const KernelFormula& kernel) {
  return kernel.formula->uses("x") || kernel.formula->uses("y") || kernel.formula->uses("z");
}

/// Values of the formula at a place, from every ordinate of a small oblique set into another.
std::vector<double> fingerprint(const KernelFormula& kernel, const Vec3& place) {
  static const DirectionSet set =
      rotated(directions_triangular(6), rotation_about(Vec3(1, 2, 3).normalized(), 40));
  KernelFormula there = kernel;
  there.place = place;
  std::vector<double> values;
  for (int m = 0; m < set.count(); ++m)
    values.push_back(
        there.at(set.direction(OrdinateIndex(m)), set.direction(OrdinateIndex((7 * m + 3) % set.count()))));
  return values;
}

/// Returns whether all are multiples of one another. Values that are not finite are not.
bool are_proportional(const std::vector<std::vector<double>>& prints) {
  std::size_t cell = 0, pair = 0;
  for (std::size_t c = 0; c < prints.size(); ++c)
    for (std::size_t i = 0; i < prints[c].size(); ++i)
      if (std::abs(prints[c][i]) > std::abs(prints[cell][pair])) cell = c, pair = i;
  const double largest = prints[cell][pair];
  for (const std::vector<double>& print : prints)
    for (std::size_t i = 0; i < print.size(); ++i)
      if (!(std::abs(print[i] * largest - print[pair] * prints[cell][i]) <=
            product_agreement * largest * largest))
        return false;
  return true;
}

}  // namespace

std::vector<KernelPlace> kernel_places(const KernelFormula& kernel, const TetrahedralMesh& mesh, int region) {
  if (!varies(kernel)) return {};
  std::vector<CellIndex> cells;
  std::vector<std::vector<double>> prints;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    if (mesh.region(CellIndex(c)) != region) continue;
    cells.emplace_back(c);
    prints.push_back(fingerprint(kernel, mesh.centroid(cells.back())));
  }
  if (prints.empty() || are_proportional(prints)) return {};
  std::vector<KernelPlace> places;
  std::map<std::vector<double>, std::size_t> known;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto [at, is_new] = known.emplace(std::move(prints[i]), places.size());
    if (is_new) places.push_back({mesh.centroid(cells[i]), {}});
    places[at->second].cells.push_back(cells[i]);
  }
  return places;
}

std::vector<KernelPlace> kernel_places(const Problem& problem, int region, int band) {
  const Medium& medium = problem.medium(region);
  if (!medium.is_directional(band)) return {};
  const auto* kernel = std::get_if<KernelFormula>(&medium.directional[static_cast<std::size_t>(band)]);
  return kernel == nullptr ? std::vector<KernelPlace>{} : kernel_places(*kernel, problem.mesh(), region);
}

}  // namespace etendue
