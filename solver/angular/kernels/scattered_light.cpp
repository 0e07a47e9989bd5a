// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/kernels/scattered_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/materials/kernels/micro_flakes.h"

namespace etendue {
namespace {

/// So far beside straight ahead, where flakes that are seen edge on and peaks of formulas have no value.
constexpr double straight = 1e-6;

}  // namespace

double scattering_value(const DirectionalScattering& scattering, const LeafNormals& normals,
                        const Vec3& before, const Vec3& after) {
  if (const auto* leaves = std::get_if<LeafCanopy>(&scattering))
    return leaf_value(*leaves, normals, before, after);
  const Vec3 beside = (after - before).norm() < straight
                          ? Vec3((after + straight * after.unitOrthogonal()).normalized())
                          : after;
  if (const auto* flakes = std::get_if<MicroFlakes>(&scattering)) return flake_value(*flakes, before, beside);
  return std::get<KernelFormula>(scattering).at(before, beside);
}

ScatteredLight::ScatteredLight(DirectionalScattering scattering, const DirectionSet& set)
    : scattering_(std::move(scattering)), set_(set) {
  const auto* leaves = std::get_if<LeafCanopy>(&scattering_);
  if (leaves == nullptr) return;
  normals_ = leaf_normals(leaves->angles);
  cosines_.resize(static_cast<Eigen::Index>(normals_.normals.size()), set.count());
  for (Eigen::Index m = 0; m < cosines_.cols(); ++m)
    for (Eigen::Index i = 0; i < cosines_.rows(); ++i)
      cosines_(i, m) =
          set.directions()[static_cast<std::size_t>(m)].dot(normals_.normals[static_cast<std::size_t>(i)]);
}

void ScatteredLight::scatter(const Beams& beams, std::span<double> values) const {
  if (const auto* leaves = std::get_if<LeafCanopy>(&scattering_))
    return scatter_by_leaves(*leaves, beams, values);
  std::fill(values.begin(), values.end(), 0.0);
  for (const auto& [direction, fluence] : beams)
    for (std::size_t m = 0; m < values.size(); ++m)
      values[m] += fluence * scattering_value(scattering_, normals_, direction, set_.directions()[m]);
}

// The irradiance on either side of the leaves of a normal n is summed over the beams first. Each side sends
// (1/pi)|w.n| of it: the reflectance of it back, the transmittance on through the leaf.
void ScatteredLight::scatter_by_leaves(const LeafCanopy& leaves, const Beams& beams,
                                       std::span<double> values) const {
  const auto count = static_cast<Eigen::Index>(normals_.normals.size());
  // Sent to the side of the normal, and to the other.
  Eigen::VectorXd ahead(count), back(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3& normal = normals_.normals[static_cast<std::size_t>(i)];
    double along = 0, against = 0;
    for (const auto& [direction, fluence] : beams) {
      const double arriving = fluence * direction.dot(normal);
      (arriving > 0 ? along : against) += std::abs(arriving);
    }
    const double share = normals_.shares[static_cast<std::size_t>(i)] / std::numbers::pi;
    ahead[i] = share * (leaves.transmittance * along + leaves.reflectance * against);
    back[i] = share * (leaves.transmittance * against + leaves.reflectance * along);
  }
  for (std::size_t m = 0; m < values.size(); ++m) {
    const auto cosines = cosines_.col(static_cast<Eigen::Index>(m)).array();
    values[m] = (cosines.max(0.0) * ahead.array() + (-cosines).max(0.0) * back.array()).sum();
  }
}

}  // namespace etendue
