// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Equation numbers are those of docs/theory/theory.md.
#include "solver/transport/kernel/reference_sweep.h"

#include <Eigen/Dense>
#include <algorithm>

namespace etendue {
namespace {

/// Integral of lambda_i lambda_j over a cell, divided by its volume.
double mass(int i, int j, bool lumped) {
  if (lumped) return i == j ? 1.0 / 4 : 0;
  return i == j ? 2.0 / 20 : 1.0 / 20;
}

/// a_f = w . (A_f n_f) of the four faces, n_f out of the cell [length^2]. Light enters where a_f < 0.
Eigen::Vector4d projected_areas_of(const TetrahedralMesh& mesh, CellIndex cell, const Vec3& direction) {
  Eigen::Vector4d a;
  for (int f = 0; f < 4; ++f) {
    const FaceIndex face(mesh.faces(cell)[static_cast<std::size_t>(f)]);
    a[f] = (mesh.owner(face) == cell ? 1 : -1) * mesh.area_normal(face).dot(direction);
  }
  return a;
}

/// The matrix A of equation (5), or of (8). `removed` is sigma_t V [length^2].
Eigen::Matrix4d cell_matrix(const Eigen::Vector4d& a, double removed, bool lumped) {
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      matrix(i, j) = removed * mass(i, j, lumped) + a[i] / 12;
      for (int f = 0; f < 4; ++f)
        if (f != i && f != j) matrix(i, j) += std::max(a[f], 0.0) / 12 * (i == j ? 2 : 1);
    }
  return matrix;
}

/// u_up(f, j) of equation (5): the radiance at a vertex of a face on its other side.
double upwind(const ReferenceSweep& sweep, const std::vector<double>& radiance, CellIndex cell,
              FaceIndex face, std::int32_t vertex) {
  const TetrahedralMesh& mesh = sweep.mesh;
  const auto place_in = [vertex](const auto& vertices) {
    return static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin());
  };
  if (face.value() < mesh.boundary_face_count())
    return sweep.inflow[3 * face.at() + place_in(mesh.vertices(face))];
  const CellIndex other = mesh.owner(face) == cell ? mesh.neighbour(face) : mesh.owner(face);
  return radiance[4 * other.at() + place_in(mesh.vertices(other))];
}

/// The right-hand side b of equation (5): the source of the cell, and the light that enters.
Eigen::Vector4d right_side(const ReferenceSweep& sweep, const std::vector<double>& radiance, CellIndex cell,
                           const Eigen::Vector4d& a) {
  const TetrahedralMesh& mesh = sweep.mesh;
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      b[i] += mesh.volume(cell) * mass(i, j, sweep.lumped[cell.at()] != 0) *
              sweep.source[4 * cell.at() + static_cast<std::size_t>(j)];
      for (int f = 0; f < 4; ++f) {
        if (f == i || f == j || a[f] >= 0) continue;
        const FaceIndex face(mesh.faces(cell)[static_cast<std::size_t>(f)]);
        const std::int32_t vertex = mesh.vertices(cell)[static_cast<std::size_t>(j)];
        b[i] += -a[f] / 12 * (i == j ? 2 : 1) * upwind(sweep, radiance, cell, face, vertex);
      }
    }
  return b;
}

}  // namespace

std::vector<double> reference_sweep(const ReferenceSweep& sweep) {
  std::vector<double> radiance(4 * sweep.order.size());
  for (const CellIndex cell : sweep.order) {
    const Eigen::Vector4d a = projected_areas_of(sweep.mesh, cell, sweep.direction);
    const double removed = sweep.extinction[cell.at()] * sweep.mesh.volume(cell);
    const Eigen::Matrix4d matrix = cell_matrix(a, removed, sweep.lumped[cell.at()] != 0);
    const Eigen::Vector4d u = matrix.partialPivLu().solve(right_side(sweep, radiance, cell, a));
    std::copy(u.begin(), u.end(), radiance.begin() + static_cast<std::ptrdiff_t>(4 * cell.at()));
  }
  return radiance;
}

}  // namespace etendue
