// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/exact/exact_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "solver/transport/scattering/dense_scattering.h"

namespace etendue {
namespace {

[[noreturn]] void refuse(const Vec3& point, const Vec3& direction) {
  char text[240];
  std::snprintf(
      text, sizeof text,
      "is not finite, or has no gradient, at the point (%.6g, %.6g, %.6g) in the direction (%.6g, %.6g, "
      "%.6g); give a radiance that is smooth in the domain",
      point.x(), point.y(), point.z(), direction.x(), direction.y(), direction.z());
  throw InputError(text);
}

}  // namespace

ExactInput::ExactInput(const Problem& problem, const DirectionSet& directions, const ExactRadiance& radiance)
    : problem_(problem),
      directions_(directions),
      plan_(plan_scattering(problem, directions)),
      nodes_(problem.mesh()),
      harmonics_(directions, highest_degree(plan_)) {
  for (const Medium& medium : problem.media())
    for (int band = 0; band < problem.band_count(); ++band)
      if (medium.is_directional(band) || medium.absorbs_by_direction(band))
        throw InputError(
            "is not for leaves, flakes, kernels or absorption by direction; use a phase function and "
            "absorption without wx, wy, wz in the region " +
            medium.name);
  fill_values(radiance);
  fill_moments();
  fill_kernels();
  fill_matrices();
}

void ExactInput::fill_values(const ExactRadiance& radiance) {
  radiance_.resize(static_cast<std::size_t>(directions_.count()) * nodes_.count());
  streaming_.resize(radiance_.size());
#pragma omp parallel for schedule(static)
  for (std::int32_t m = 0; m < directions_.count(); ++m) {
    const OrdinateIndex ordinate(m);
    const Vec3& direction = directions_.direction(ordinate);
    for (std::size_t node = 0; node < nodes_.count(); ++node) {
      const Dual value = radiance.with_gradient(nodes_.point(node), direction);
      radiance_[at(ordinate, node)] = value.value;
      streaming_[at(ordinate, node)] = direction.dot(value.gradient);
    }
  }
  for (std::size_t i = 0; i < radiance_.size(); ++i)
    if (!std::isfinite(radiance_[i]) || !std::isfinite(streaming_[i]))
      refuse(nodes_.point(i % nodes_.count()), directions_.directions()[i / nodes_.count()]);
}

void ExactInput::fill_moments() {
  const auto count = static_cast<std::size_t>(harmonics_.count());
  moments_.assign(nodes_.count() * count, 0);
#pragma omp parallel for schedule(static)
  for (std::size_t node = 0; node < nodes_.count(); ++node)
    for (std::int32_t m = 0; m < directions_.count(); ++m) {
      const OrdinateIndex ordinate(m);
      const double weighted = directions_.weight(ordinate) * radiance_[at(ordinate, node)];
      for (std::size_t k = 0; k < count; ++k)
        moments_[node * count + k] += weighted * harmonics_.of(ordinate)[k];
    }
}

void ExactInput::fill_kernels() {
  std::size_t row = 0;
  for (const Medium& medium : problem_.media())
    for (const PhaseFunction& phase : medium.phase) {
      const ScatteringTreatment& how = plan_[row++];
      for (int k = 0; k < harmonics_.count(); ++k) {
        const int degree = harmonics_.degree_of(k);
        kernels_.push_back(degree > how.degree
                               ? 0
                               : (1 - how.forward) * reduced_moment(phase, degree, how.forward) /
                                     full_range(problem_.space()));
      }
    }
}

void ExactInput::fill_matrices() {
  matrix_of_.assign(plan_.size(), -1);
  const Eigen::Index count = directions_.count(), nodes = static_cast<Eigen::Index>(nodes_.count());
  const Eigen::Map<const Eigen::VectorXd> weights(directions_.weights().data(), count);
  const Eigen::Map<const Eigen::MatrixXd> radiance(radiance_.data(), nodes, count);  // [node][ordinate]
  for (const DenseGroup& group : dense_groups(problem_, directions_, plan_)) {
    for (const int band : group.bands)
      matrix_of_[static_cast<std::size_t>(group.region * problem_.band_count() + band)] =
          static_cast<int>(matrices_.size());
    const Eigen::MatrixXd scattered = radiance * weights.asDiagonal() * group.kernel().rate.transpose();
    matrices_.push_back({group.kernel().leaving, {scattered.data(), scattered.data() + scattered.size()}});
  }
}

double ExactInput::scattered(OrdinateIndex m, std::size_t node, std::span<const double> kernel) const {
  const std::span<const double> harmonics = harmonics_.of(m);
  const double* moments = &moments_[node * kernel.size()];
  double sum = 0;
  for (std::size_t k = 0; k < kernel.size(); ++k) sum += kernel[k] * harmonics[k] * moments[k];
  return sum;
}

void ExactInput::add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  const auto count = static_cast<std::size_t>(harmonics_.count());
  const int bands = problem_.band_count();
  const std::array<std::size_t, 10> nodes = nodes_.nodes(cell);
  for (int band = 0; band < bands; ++band) {
    const double scattering = problem_.scattering(cell, band);
    const auto row = static_cast<std::size_t>(problem_.mesh().region(cell) * bands + band);
    const MatrixTerms* matrix =
        matrix_of_[row] < 0 ? nullptr : &matrices_[static_cast<std::size_t>(matrix_of_[row])];
    const double leaving = matrix == nullptr ? 1 - plan_[row].forward : matrix->leaving[m.at()];
    const double extinction = scattering * leaving + problem_.absorption(cell, band);
    const std::span<const double> kernel(&kernels_[row * count], count);
    std::array<double, 10> source{};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      source[i] = streaming_[at(m, nodes[i])] + extinction * radiance_[at(m, nodes[i])];
      if (scattering > 0)
        source[i] -= scattering * (matrix == nullptr ? scattered(m, nodes[i], kernel)
                                                     : matrix->scattered[at(m, nodes[i])]);
    }
    const std::array<double, 4> projected = project(source);
    for (std::size_t i = 0; i < 4; ++i)
      values[i * static_cast<std::size_t>(bands) + static_cast<std::size_t>(band)] += projected[i];
  }
}

void ExactInput::add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  std::array<double, 6> entering{};
  const std::array<std::size_t, 6> nodes = nodes_.nodes(face);
  for (std::size_t i = 0; i < nodes.size(); ++i) entering[i] = radiance_[at(m, nodes[i])];
  const std::array<double, 3> projected = project(entering);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t band = 0; band < bands; ++band) values[i * bands + band] += projected[i];
}

std::vector<std::vector<double>> ExactInput::source_powers() const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  std::vector<std::vector<double>> powers(problem_.media().size(), std::vector<double>(bands, 0));
  std::vector<double> values(4 * bands);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::int32_t m = 0; m < directions_.count(); ++m) {
      std::fill(values.begin(), values.end(), 0);
      add_source(OrdinateIndex(m), CellIndex(c), values);
      const double factor = directions_.weight(OrdinateIndex(m)) * mesh.volume(CellIndex(c)) / 4;
      std::vector<double>& power = powers[static_cast<std::size_t>(mesh.region(CellIndex(c)))];
      for (std::size_t i = 0; i < values.size(); ++i) power[i % bands] += factor * values[i];
    }
  return powers;
}

}  // namespace etendue
