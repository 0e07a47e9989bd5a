// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/band_vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "solver/transport/iteration/band_pairs.h"
#include "solver/transport/state/safe_squares.h"

namespace etendue {
namespace {

/// Rows of one partial sum. It decides the order of sums, so it must not depend on the number of threads.
constexpr std::size_t summed_rows = 4096;

/// Calls work with the stride as a constant where it is a usual one, so that loops over it fill registers;
/// else with 0.
template <class Work>
void with_stride(std::size_t stride, const Work& work) {
  switch (stride) {
    case 1:
      return work(std::integral_constant<std::size_t, 1>());
    case 2:
      return work(std::integral_constant<std::size_t, 2>());
    case 4:
      return work(std::integral_constant<std::size_t, 4>());
    case 8:
      return work(std::integral_constant<std::size_t, 8>());
    case 16:
      return work(std::integral_constant<std::size_t, 16>());
    default:
      return work(std::integral_constant<std::size_t, 0>());
  }
}

/// Numbers [band] with as many zeros behind them as fill the stride.
std::vector<double> filled_up(const BandScalars& numbers, std::size_t stride) {
  std::vector<double> filled(numbers);
  filled.resize(stride, 0);
  return filled;
}

void append(std::vector<double>& weights, std::size_t count, double weight) {
  weights.insert(weights.end(), count, weight);
}

}  // namespace

BandVectors::BandVectors(const TetrahedralMesh& mesh, const TransportSweep& sweep)
    : is_complex_(sweep.cells().is_complex()),
      bands_(static_cast<std::size_t>(sweep.cells().bands())),
      stride_(static_cast<std::size_t>(sweep.cells().stride())),
      threads_(sweep.threads()) {
  const StateLayout layout = sweep.layout();
  const auto nodes = static_cast<std::size_t>(sweep.cells().nodes());
  const auto face_nodes = static_cast<std::size_t>(sweep.cells().face_nodes());
  const double volume = std::accumulate(mesh.volumes().begin(), mesh.volumes().end(), 0.0);
  double area = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) area += mesh.area(FaceIndex(f));
  weights_.reserve(layout.total() / stride_);
  for (const double cell : mesh.volumes())
    append(weights_, nodes, cell / volume / static_cast<double>(nodes));
  for (const std::int32_t cell : sweep.discretization().moments.angular_cells())
    append(weights_, nodes * static_cast<std::size_t>(sweep.discretization().moments.moment_count()),
           mesh.volume(CellIndex(cell)) / volume / static_cast<double>(nodes));
  // Radiances weigh what the moments that they make would weigh all together: full range times w.
  const DenseScattering& dense = sweep.discretization().dense;
  for (std::int32_t m = 0; !dense.empty() && m < sweep.directions().count(); ++m)
    for (const std::int32_t cell : dense.cells())
      append(weights_, nodes,
             full_range(sweep.problem().space()) * sweep.directions().weight(OrdinateIndex(m)) *
                 mesh.volume(CellIndex(cell)) / volume / static_cast<double>(nodes));
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    append(weights_, face_nodes, mesh.area(FaceIndex(f)) / area / static_cast<double>(face_nodes));
  // Radiance on mirrors and lagged faces: as large as the fluence it makes, shared out evenly.
  const std::size_t traces = (layout.mirrors + layout.lagged) / stride_;
  const double range = full_range(sweep.problem().space());
  append(weights_, traces, range * range / static_cast<double>(std::max<std::size_t>(traces, 1)));
}

BandScalars BandVectors::dot(const TransportState& a, const TransportState& b) const {
  return dot(a, b, BandScalars(bands_, 1));
}

BandScalars BandVectors::dot(const TransportState& a, const TransportState& b,
                             const BandScalars& factor) const {
  const std::size_t rows = weights_.size();
  const std::size_t blocks = (rows + summed_rows - 1) / summed_rows;
  std::vector<double> partial(blocks * stride_, 0);
  const std::vector<double> factors = filled_up(factor, stride_);
  const double* left = a.values().data();
  const double* right = b.values().data();
  with_stride(stride_, [&](auto constant) {
    const std::size_t stride = constant > 0 ? constant : stride_;
#pragma omp parallel for schedule(static) num_threads(threads_)
    for (std::size_t block = 0; block < blocks; ++block) {
      double* const sum = &partial[block * stride];
      const double* const by = factors.data();
      const std::size_t end = std::min(rows, (block + 1) * summed_rows);
      for (std::size_t row = block * summed_rows; row < end; ++row) {
        const double weight = weights_[row];
        const double* const x = left + row * stride;
        const double* const y = right + row * stride;
#pragma GCC ivdep
        for (std::size_t band = 0; band < stride; ++band)
          sum[band] += weight * (by[band] * x[band]) * (by[band] * y[band]);
      }
    }
  });
  BandScalars result(bands_, 0);
  for (std::size_t block = 0; block < blocks; ++block)
    for (std::size_t band = 0; band < bands_; ++band) result[band] += partial[block * stride_ + band];
  if (is_complex_) add_pairs(result);
  return result;
}

BandScalars BandVectors::norm(const TransportState& a) const {
  BandScalars result = dot(a, a), unit(bands_, 1);
  if (!std::ranges::all_of(result, is_safe_sum_of_squares)) {
    unit = units(a);
    result = dot(a, a, unit);
  }
  for (std::size_t band = 0; band < bands_; ++band) result[band] = std::sqrt(result[band]) / unit[band];
  return result;
}

BandScalars BandVectors::units(const TransportState& a) const {
  const std::size_t rows = weights_.size(), blocks = (rows + summed_rows - 1) / summed_rows;
  std::vector<double> largest(blocks * bands_, 0);
  const double* values = a.values().data();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::size_t block = 0; block < blocks; ++block)
    for (std::size_t row = block * summed_rows; row < std::min(rows, (block + 1) * summed_rows); ++row)
      for (std::size_t band = 0; band < bands_; ++band)
        largest[block * bands_ + band] =
            std::max(largest[block * bands_ + band], std::abs(values[row * stride_ + band]));
  BandScalars result(bands_, 0);
  for (std::size_t i = 0; i < largest.size(); ++i)
    result[i % bands_] = std::max(result[i % bands_], largest[i]);
  if (is_complex_) take_larger_of_pairs(result);
  for (double& value : result) value = unit_for_squares(value);
  return result;
}

void BandVectors::add(TransportState& to, const BandScalars& factor, const TransportState& from) const {
  double* sum = to.values().data();
  const double* values = from.values().data();
  const std::vector<double> factors = filled_up(factor, stride_);
  with_stride(stride_, [&](auto constant) {
    const std::size_t stride = constant > 0 ? constant : stride_;
    const double* const by = factors.data();
#pragma omp parallel for schedule(static) num_threads(threads_)
    for (std::size_t row = 0; row < weights_.size(); ++row)
#pragma GCC ivdep
      for (std::size_t band = 0; band < stride; ++band)
        sum[row * stride + band] += by[band] * values[row * stride + band];
  });
}

void BandVectors::scale(TransportState& a, const BandScalars& factor) const {
  double* values = a.values().data();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::size_t row = 0; row < weights_.size(); ++row)
    for (std::size_t band = 0; band < bands_; ++band) values[row * stride_ + band] *= factor[band];
}

}  // namespace etendue
