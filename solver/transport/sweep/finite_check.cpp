// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/finite_check.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "base/text/vector_text.h"

namespace etendue {
namespace {

/// Row of the first value of a band that is not finite; the number of rows where all are.
std::size_t first_bad_row(std::span<const double> values, std::size_t stride, std::size_t band) {
  std::size_t row = 0;
  while (row * stride < values.size() && std::isfinite(values[row * stride + band])) ++row;
  return row;
}

std::string cell_text(const TetrahedralMesh& mesh, CellIndex cell) {
  return fmt::format("cell {} at {} in region {}", cell.value(), vector_text(mesh.centroid(cell)),
                     mesh.region_names()[static_cast<std::size_t>(mesh.region(cell))]);
}

std::string face_text(const TetrahedralMesh& mesh, FaceIndex face) {
  return fmt::format("a face at {} of wall {}", vector_text(mesh.centroid(face)),
                     mesh.wall_names()[static_cast<std::size_t>(mesh.wall(face))]);
}

/// The cell or wall face of the first value of a band that is not finite.
std::string place_text(const TransportSweep& sweep, std::size_t band, const TransportState& state) {
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  const auto cell =
      first_bad_row(state.fluence(), stride, band) / static_cast<std::size_t>(sweep.cells().nodes());
  if (cell < sweep.mesh().volumes().size())
    return " in " + cell_text(sweep.mesh(), CellIndex(static_cast<std::int64_t>(cell)));
  const auto face =
      first_bad_row(state.irradiance(), stride, band) / static_cast<std::size_t>(sweep.cells().face_nodes());
  return " at " + face_text(sweep.mesh(), FaceIndex(static_cast<std::int64_t>(face)));
}

/// Clears the mark of each band that has a value in these rows that is not finite.
void check_rows(std::span<const double> values, std::size_t stride, std::vector<char>& finite) {
  for (std::size_t first = 0; first < values.size(); first += stride)
    for (std::size_t band = 0; band < finite.size(); ++band)
      finite[band] &= std::isfinite(values[first + band]) ? 1 : 0;
}

[[noreturn]] void refuse_value(const TransportSweep& sweep, int sweep_number, std::string_view quantity,
                               std::size_t band, const std::string& place) {
  throw NotFiniteError(fmt::format("sweep {}, band {}: the {} is not a finite number{}", sweep_number,
                                   sweep.problem().bands().names[band], quantity, place));
}

}  // namespace

void check_finite(const TransportSweep& sweep, int sweep_number, std::string_view quantity,
                  std::span<const double> sizes) {
  for (std::size_t band = 0; band < sizes.size(); ++band)
    if (!std::isfinite(sizes[band])) refuse_value(sweep, sweep_number, quantity, band, "");
}

void check_finite(const TransportSweep& sweep, int sweep_number, const TransportState& state) {
  std::vector<char> finite(static_cast<std::size_t>(sweep.cells().bands()), 1);
  check_rows(state.fluence(), static_cast<std::size_t>(sweep.cells().stride()), finite);
  check_rows(state.irradiance(), static_cast<std::size_t>(sweep.cells().stride()), finite);
  for (std::size_t band = 0; band < finite.size(); ++band)
    if (!finite[band]) refuse_value(sweep, sweep_number, "radiance", band, place_text(sweep, band, state));
}

}  // namespace etendue
