// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/quadratic_reconstruction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "base/parallel/parallel_for.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

/// The best linear fit of 4 l_a l_b in a cell is this at a and b, and the other one at the vertices that the
/// edge does not touch: from the integrals of products of l.
constexpr double fit_at_edge = 8. / 15, fit_elsewhere = -2. / 15;

double fit(std::size_t edge, std::size_t vertex) {
  const auto [a, b] = cell_edges[edge];
  return vertex == a || vertex == b ? fit_at_edge : fit_elsewhere;
}

/// The barycentric coordinates of a cell at the vertices of another one, [vertex][coordinate].
Eigen::Matrix4d coordinates(const TetrahedralMesh& mesh, CellIndex of, CellIndex at) {
  Eigen::Matrix4d own, there;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const auto vertex = static_cast<std::size_t>(i);
    own.row(i) << 1, corner_of(mesh, of, vertex).transpose();
    there.row(i) << 1, corner_of(mesh, at, vertex).transpose();
  }
  // Distances from one of its vertices: far from the origin digits would be lost.
  const Eigen::RowVector4d origin(0, own(0, 1), own(0, 2), own(0, 3));
  own.rowwise() -= origin;
  there.rowwise() -= origin;
  return there * own.inverse();
}

/// What the functions 4 l_a l_b of a cell, less their own fits, are in another one, fitted there,
/// [vertex][edge].
Eigen::Matrix<double, 4, 6> edge_functions_at(const Eigen::Matrix4d& at) {
  Eigen::Matrix<double, 4, 6> values;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto a = static_cast<Eigen::Index>(cell_edges[e].first),
               b = static_cast<Eigen::Index>(cell_edges[e].second);
    for (Eigen::Index v = 0; v < 4; ++v) {
      double value = 4 * at(v, a) * at(v, b);
      for (std::size_t there = 0; there < 6; ++there) {
        const auto i = static_cast<Eigen::Index>(cell_edges[there].first),
                   j = static_cast<Eigen::Index>(cell_edges[there].second);
        value -= (at(i, a) - at(j, a)) * (at(i, b) - at(j, b)) * fit(there, static_cast<std::size_t>(v));
      }
      for (std::size_t own = 0; own < 4; ++own) value -= at(v, static_cast<Eigen::Index>(own)) * fit(e, own);
      values(v, static_cast<Eigen::Index>(e)) = value;
    }
  }
  return values;
}

/// The cells of its region two faces away at most, without itself.
std::vector<CellIndex> cells_around(const TetrahedralMesh& mesh, CellIndex cell) {
  std::vector<CellIndex> around{cell};
  std::size_t first = 0;
  for (int layer = 0; layer < 2; ++layer) {
    const std::size_t last = around.size();
    for (; first < last; ++first)
      for (const std::int32_t f : mesh.faces(around[first])) {
        if (f < mesh.boundary_face_count()) continue;
        const FaceIndex face(f);
        const CellIndex next = mesh.owner(face) == around[first] ? mesh.neighbour(face) : mesh.owner(face);
        if (mesh.region(next) == mesh.region(cell) && std::ranges::find(around, next) == around.end())
          around.push_back(next);
      }
  }
  around.erase(around.begin());
  return around;
}

/// Least-squares reconstruction of the quadratic part in a cell from the values in the cells around it.
class CellReconstruction {
 public:
  CellReconstruction(const TetrahedralMesh& mesh, CellIndex cell) : around_(cells_around(mesh, cell)) {
    const auto count = static_cast<Eigen::Index>(4 * around_.size());
    straight_.resize(count, 4);
    Eigen::MatrixXd quadratic(count, 6);
    for (std::size_t k = 0; k < around_.size(); ++k) {
      const Eigen::Matrix4d at = coordinates(mesh, cell, around_[k]);
      straight_.middleRows<4>(static_cast<Eigen::Index>(4 * k)) = at;
      quadratic.middleRows<4>(static_cast<Eigen::Index>(4 * k)) = edge_functions_at(at);
    }
    if (count > 0) inverse_ = quadratic.completeOrthogonalDecomposition().pseudoInverse();
  }

  std::span<const CellIndex> around() const { return around_; }

  /// Writes the values of quadratic_nodes from those at the vertices of the cell and of those around,
  /// [4][band] each.
  void reconstruct(const double* cell, std::span<const double* const> others, std::size_t bands,
                   double* reconstructed) const {
    Eigen::VectorXd difference(straight_.rows());
    for (std::size_t b = 0; b < bands; ++b) {
      const Eigen::Vector4d own(cell[b], cell[bands + b], cell[2 * bands + b], cell[3 * bands + b]);
      for (std::size_t k = 0; k < others.size(); ++k)
        for (std::size_t v = 0; v < 4; ++v)
          difference(static_cast<Eigen::Index>(4 * k + v)) = others[k][v * bands + b];
      Eigen::Matrix<double, 6, 1> quadratic = Eigen::Matrix<double, 6, 1>::Zero();
      if (!others.empty()) quadratic = inverse_ * (difference - straight_ * own);
      for (std::size_t v = 0; v < 4; ++v) {
        double value = own(static_cast<Eigen::Index>(v));
        for (std::size_t e = 0; e < 6; ++e) value -= quadratic(static_cast<Eigen::Index>(e)) * fit(e, v);
        reconstructed[v * bands + b] = value;
      }
      for (std::size_t e = 0; e < 6; ++e)
        reconstructed[(4 + e) * bands + b] = quadratic(static_cast<Eigen::Index>(e));
    }
  }

 private:
  std::vector<CellIndex> around_;
  Eigen::MatrixXd straight_;  ///< [vertex of those around][vertex of the cell]
  Eigen::MatrixXd inverse_;   ///< [edge][vertex of those around]
};

}  // namespace

SavedState quadratic_reconstruction(const Problem& problem, const SavedState& state,
                                    std::span<const std::int32_t> rows, int threads) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const auto row_count = static_cast<std::size_t>(*std::ranges::max_element(rows));
  const std::size_t moments = row_count > 0 ? state.moments.size() / (row_count * 4 * bands) : 0;
  SavedState reconstructed = state;
  reconstructed.fluence.resize(rows.size() * quadratic_nodes * bands);
  reconstructed.moments.resize(row_count * moments * quadratic_nodes * bands);
  parallel_for(rows.size(), threads, 64, [&](std::size_t c) {
    const CellIndex cell(static_cast<std::int32_t>(c));
    const CellReconstruction reconstruction(mesh, cell);
    std::vector<const double*> others;
    for (const CellIndex next : reconstruction.around())
      others.push_back(&state.fluence[next.at() * 4 * bands]);
    reconstruction.reconstruct(&state.fluence[c * 4 * bands], others, bands,
                               &reconstructed.fluence[c * quadratic_nodes * bands]);
    if (rows[c] == 0) return true;
    if (std::ranges::any_of(reconstruction.around(), [&](CellIndex next) { return rows[next.at()] == 0; }))
      others.clear();
    for (std::size_t k = 0; k < moments; ++k) {
      const auto place = [&](std::size_t of) {
        return (static_cast<std::size_t>(rows[of]) - 1) * moments + k;
      };
      for (std::size_t i = 0; i < others.size(); ++i)
        others[i] = &state.moments[place(reconstruction.around()[i].at()) * 4 * bands];
      reconstruction.reconstruct(&state.moments[place(c) * 4 * bands], others, bands,
                                 &reconstructed.moments[place(c) * quadratic_nodes * bands]);
    }
    return true;
  });
  return reconstructed;
}

}  // namespace etendue
