// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/ray_segment.h"

#include <algorithm>
#include <cmath>

#include "base/quadrature/unit_rule.h"
#include "solver/uncollided/rays/attenuation.h"

namespace etendue {
namespace {

/// Adds the integrals of the shape functions along a path of light of a power per solid angle through a
/// medium with these coefficients.
void add_values(const RaySegment& segment, const std::array<double, 4>& value,
                const PathCoefficients& coefficients, std::size_t band, NodalMoments& moments) {
  for (std::size_t i = 0; i < 4; ++i) {
    moments.at(i, 0, band) += value[i];
    for (std::size_t axis = 0; axis < 3; ++axis)
      moments.at(i, 1 + axis, band) += value[i] * segment.direction[static_cast<Eigen::Index>(axis)];
  }
  moments.add_scattered(segment.direction, value, band, coefficients.scattering);
  add_losses(value, 1, coefficients, band, 1, moments);
}

void add_homogeneous_segment(const RaySegment& segment, const PathCoefficients& coefficients,
                             std::size_t band, double sent, NodalMoments& moments) {
  const AttenuationIntegrals attenuated = attenuation_integrals(coefficients.extinction(), segment.length);
  std::array<double, 4> value;
  for (std::size_t i = 0; i < 4; ++i)
    value[i] = sent * (segment.shape[i] * attenuated.constant + segment.rise[i] * attenuated.linear);
  add_values(segment, value, coefficients, band, moments);
}

/// Optical thickness over which five nodes integrate an exponential decay to 1e-9.
constexpr double thickness_of_panel = 1;

/// Where coefficients rise from one end to the other the optical depth is a square in the length, and its
/// integrals are done by Gauss's rule.
void add_varying_segment(const RaySegment& segment, const PathCoefficients& from, const PathCoefficients& to,
                         std::size_t band, double sent, NodalMoments& moments) {
  static const GaussRule rule = unit_rule(5);
  const double first = from.extinction(), rise = to.extinction() - first;
  const double thickness = std::max(first, first + rise) * segment.length;
  const int panels = std::clamp(static_cast<int>(std::ceil(thickness / thickness_of_panel)), 1, 64);
  for (int panel = 0; panel < panels; ++panel)
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double t = (panel + rule.nodes[k]) / panels, s = t * segment.length;
      const double arrives =
          sent * rule.weights[k] * segment.length / panels * std::exp(-s * (first + t * rise / 2));
      std::array<double, 4> value;
      for (std::size_t i = 0; i < 4; ++i) value[i] = arrives * (segment.shape[i] + segment.rise[i] * s);
      add_values(segment, value,
                 {from.absorption + t * (to.absorption - from.absorption),
                  from.scattering + t * (to.scattering - from.scattering)},
                 band, moments);
    }
}

}  // namespace

RaySegment segment_through(const LitCell& cell, const std::array<Vec3, 4>& gradients, const Vec3& entry,
                           const Vec3& direction, double length) {
  RaySegment segment{entry, direction, length, {}, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    segment.shape[i] = 0.25 + gradients[i].dot(entry - cell.centroid);
    segment.rise[i] = gradients[i].dot(direction);
  }
  return segment;
}

std::array<Vec3, 4> shape_gradients(const LitCell& cell) {
  std::array<Vec3, 4> gradients;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& a = cell.corners[(i + 1) % 4];
    const Vec3 normal = (cell.corners[(i + 2) % 4] - a).cross(cell.corners[(i + 3) % 4] - a);
    gradients[i] = normal / normal.dot(cell.corners[i] - a);
  }
  return gradients;
}

void add_segment(const RayMatter& matter, const LitCell& cell, const RaySegment& segment,
                 std::span<const double> power, NodalMoments& moments) {
  const RayMatter::View view = matter.empty() ? RayMatter::View{} : matter.view(segment.direction);
  const bool uneven = matter.varies(cell.index);
  for (std::size_t b = 0; b < power.size(); ++b)
    if (uneven)
      add_varying_segment(segment, matter.at(cell.index, b, view, segment.entry),
                          matter.at(cell.index, b, view, segment.entry + segment.length * segment.direction),
                          b, power[b], moments);
    else
      add_homogeneous_segment(segment, matter.at(cell.index, b, view), b, power[b], moments);
}

void add_losses(const std::array<double, 4>& shape, double measure, const PathCoefficients& coefficients,
                std::size_t band, double fluence, NodalMoments& moments) {
  if (moments.components() <= NodalMoments::collided) return;
  moments.add(shape, measure, band, coefficients.absorption * fluence, NodalMoments::absorbed);
  moments.add(shape, measure, band, coefficients.scattering * fluence, NodalMoments::collided);
}

}  // namespace etendue
