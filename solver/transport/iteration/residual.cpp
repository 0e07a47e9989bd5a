// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/residual.h"

#include <algorithm>
#include <cmath>

#include "solver/transport/iteration/band_pairs.h"
#include "solver/transport/state/safe_squares.h"

namespace etendue {
namespace {

/// Norms of sign a + b, or of b alone where `a` is null, whose squares are those of values times `unit`
/// [band].
FieldNorms norms_in(const std::vector<double>& unit, const TetrahedralMesh& mesh, const TransportSweep& sweep,
                    double sign, const TransportState* a, const TransportState& b) {
  const auto bands = static_cast<std::size_t>(sweep.cells().bands());
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  const auto add_squares = [&](std::span<const double> left, std::span<const double> right, std::size_t first,
                               std::size_t nodes, double weight, std::vector<double>& sums) {
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t band = 0; band < bands; ++band) {
        const std::size_t at = (first + i) * stride + band;
        const double value = unit[band] * (right[at] + (left.empty() ? 0 : sign * left[at]));
        sums[band] += weight * value * value;
      }
  };
  using Part = std::span<const double>;
  const auto nodes = static_cast<std::size_t>(sweep.cells().nodes());
  const auto face_nodes = static_cast<std::size_t>(sweep.cells().face_nodes());
  FieldNorms result{std::vector<double>(bands, 0), std::vector<double>(bands, 0)};
  for (std::size_t c = 0; c < static_cast<std::size_t>(mesh.cell_count()); ++c)
    add_squares(a != nullptr ? a->fluence() : Part{}, b.fluence(), c * nodes, nodes, mesh.volumes()[c],
                result.volume);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (!sweep.walls().reflects(face)) continue;
    add_squares(a != nullptr ? a->irradiance() : Part{}, b.irradiance(), face.at() * face_nodes, face_nodes,
                mesh.area(face), result.walls);
  }
  if (sweep.cells().is_complex()) {
    add_pairs(result.volume);
    add_pairs(result.walls);
  }
  for (std::size_t band = 0; band < bands; ++band) {
    result.volume[band] = std::sqrt(result.volume[band]) / unit[band];
    result.walls[band] = std::sqrt(result.walls[band]) / unit[band];
  }
  return result;
}

/// Returns whether the larger norm of each band comes from a sum of squares without overflow or underflow.
bool are_safe(const FieldNorms& norms) {
  for (std::size_t b = 0; b < norms.volume.size(); ++b) {
    const double norm = std::max(norms.volume[b], norms.walls[b]);
    if (!is_safe_sum_of_squares(norm * norm)) return false;
  }
  return true;
}

/// Powers of two that bring the largest fluence and irradiance of two states near 1 [band]; `a` may be null.
std::vector<double> units(const TransportSweep& sweep, const TransportState* a, const TransportState& b) {
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  std::vector<double> result(static_cast<std::size_t>(sweep.cells().bands()), 0);
  const auto add = [&](std::span<const double> values) {
    for (std::size_t first = 0; first < values.size(); first += stride)
      for (std::size_t band = 0; band < result.size(); ++band)
        result[band] = std::max(result[band], std::abs(values[first + band]));
  };
  for (const TransportState* state : {a, &b}) {
    if (state == nullptr) continue;
    add(state->fluence());
    add(state->irradiance());
  }
  if (sweep.cells().is_complex()) take_larger_of_pairs(result);
  for (double& value : result) value = unit_for_squares(value);
  return result;
}

/// Norms of sign a + b, or of b alone where `a` is null.
FieldNorms norms(const TetrahedralMesh& mesh, const TransportSweep& sweep, double sign,
                 const TransportState* a, const TransportState& b) {
  const std::vector<double> ones(static_cast<std::size_t>(sweep.cells().bands()), 1);
  const FieldNorms plain = norms_in(ones, mesh, sweep, sign, a, b);
  if (are_safe(plain)) return plain;
  return norms_in(units(sweep, a, b), mesh, sweep, sign, a, b);
}

// Only where the field is exactly dark there is nothing to compare with; NaN must not look like that.
double ratio(double change, double field) { return field == 0 ? 0 : change / field; }

/// The larger one, or NaN where one of them is.
double larger(double a, double b) { return std::isnan(b) || b > a ? b : a; }

std::vector<double> ratios(const FieldNorms& size, const FieldNorms& field) {
  std::vector<double> result;
  for (std::size_t b = 0; b < size.volume.size(); ++b)
    result.push_back(larger(ratio(size.volume[b], field.volume[b]), ratio(size.walls[b], field.walls[b])));
  return result;
}

}  // namespace

FieldNorms field_norms(const TetrahedralMesh& mesh, const TransportSweep& sweep, const TransportState& state,
                       const TransportState& change) {
  return norms(mesh, sweep, 1, &state, change);
}

std::vector<double> relative_size(const TetrahedralMesh& mesh, const TransportSweep& sweep,
                                  const TransportState& change, const FieldNorms& field) {
  return ratios(norms(mesh, sweep, 1, nullptr, change), field);
}

std::vector<double> relative_residual(const TetrahedralMesh& mesh, const TransportSweep& sweep,
                                      const TransportState& last, const TransportState& next) {
  return ratios(norms(mesh, sweep, -1, &last, next), norms(mesh, sweep, 1, nullptr, next));
}

std::vector<double> relative_change(const TetrahedralMesh& mesh, const TransportSweep& sweep,
                                    const TransportState& state, const TransportState& change) {
  return relative_size(mesh, sweep, change, field_norms(mesh, sweep, state, change));
}

}  // namespace etendue
