// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/kernels/kernel_coefficient.h"

#include <fmt/format.h>

#include <regex>
#include <utility>

#include "solver/angular/kernels/directional_kernel.h"
#include "solver/angular/kernels/kernel_places.h"
#include "solver/materials/kernels/kernel_formula.h"

namespace etendue {
namespace {

/// Places and pairs of directions among which a formula's largest value is looked for.
constexpr int places_looked_at = 50, pairs_looked_at = 40;

std::vector<Vec3> places_in(const TetrahedralMesh& mesh, int region) {
  std::vector<Vec3> centroids;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    if (mesh.region(CellIndex(c)) != region) continue;
    Vec3 sum = Vec3::Zero();
    for (const std::int32_t v : mesh.vertices(CellIndex(c))) sum += mesh.point(VertexIndex(v));
    centroids.push_back(sum / 4);
  }
  std::vector<Vec3> places;
  const std::size_t step = std::max<std::size_t>(1, centroids.size() / places_looked_at);
  for (std::size_t i = 0; i < centroids.size(); i += step) places.push_back(centroids[i]);
  return places;
}

using Pair = std::pair<Vec3, Vec3>;

std::vector<Pair> pairs_in(const DirectionSet& set) {
  std::vector<Pair> pairs;
  for (int i = 0; i < pairs_looked_at; ++i)
    pairs.emplace_back(set.directions()[static_cast<std::size_t>((37 * i) % set.count())],
                       set.directions()[static_cast<std::size_t>((53 * i + 5) % set.count())]);
  return pairs;
}

double value(const KernelFormula& kernel, const Vec3& place, const Pair& pair) {
  KernelFormula there = kernel;
  there.place = place;
  return there.at(pair.first, pair.second);
}

/// The formula with numbers in place of the directions.
std::string along(const KernelFormula& kernel, const Pair& pair) {
  std::string text = kernel.formula->text();
  const char* const names[] = {"wx", "wy", "wz", "vx", "vy", "vz"};
  for (int i = 0; i < 6; ++i)
    text = std::regex_replace(text, std::regex(fmt::format("\\b{}\\b", names[i])),
                              fmt::format("({:.17g})", i < 3 ? pair.first[i] : pair.second[i - 3]));
  return text;
}

/// The mean of a kernel that is no product, over places too: for fields and the log to show, since every cell
/// is scattered by its own matrix.
Coefficient mean_of_any(const KernelFormula& kernel, const std::vector<Vec3>& places) {
  KernelFormula there = kernel;
  double sum = 0;
  for (const Vec3& place : places) {
    there.place = place;
    // Few directions at each of many places.
    sum += mean_scattering(there, 3);
  }
  return sum / static_cast<double>(places.size());
}

Coefficient of_formula(KernelFormula& kernel, const DirectionSet& directions, const TetrahedralMesh& mesh,
                       int region) {
  const bool varies = kernel.formula->uses("x") || kernel.formula->uses("y") || kernel.formula->uses("z");
  if (!varies) return mean_scattering(kernel);
  if (kernel.extinction)
    throw InputError(
        "the kernel depends on the place and extinction is given beside it; give absorption instead");
  const std::vector<Vec3> places = places_in(mesh, region);
  const std::vector<Pair> pairs = pairs_in(directions);
  Pair reference = pairs.front();
  double largest = -1;
  for (const Vec3& place : places)
    for (const Pair& pair : pairs)
      if (const double k = value(kernel, place, pair); k > largest) {
        largest = k;
        kernel.place = place;
        reference = pair;
      }
  if (!(largest > 0)) return 0;
  if (!kernel_places(kernel, mesh, region).empty()) return mean_of_any(kernel, places);
  return Coefficient(
      Expression(fmt::format("{:.17g}*({})", mean_scattering(kernel) / largest, along(kernel, reference)),
                 {"x", "y", "z"}));
}

}  // namespace

Coefficient kernel_scattering(DirectionalScattering& kernel, const DirectionSet& directions,
                              const TetrahedralMesh& mesh, int region) {
  if (auto* formula = std::get_if<KernelFormula>(&kernel))
    return of_formula(*formula, directions, mesh, region);
  if (auto* matrix = std::get_if<KernelMatrix>(&kernel)) {
    KernelMatrix alone = *matrix;
    alone.extinction.reset();
    return directional_kernel(alone, directions).reference;
  }
  return 0;
}

std::optional<double> kernel_extinction(const DirectionalScattering& kernel) {
  if (const auto* formula = std::get_if<KernelFormula>(&kernel)) return formula->extinction;
  if (const auto* matrix = std::get_if<KernelMatrix>(&kernel)) return matrix->extinction;
  return std::nullopt;
}

}  // namespace etendue
