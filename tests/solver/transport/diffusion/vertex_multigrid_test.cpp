// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/vertex_multigrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "solver/transport/diffusion/aggregation.h"
#include "solver/transport/diffusion/diffusion_matrix.h"
#include "solver/transport/diffusion/vertex_space.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::vertex_multigrid_test {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Diffusion on the vertices of a cube with black walls: D = `jump` where x > 1/2, else 1, and absorption.
Matrix cube_matrix(double volume, double jump = 1, double absorption = 0) {
  const TetrahedralMesh mesh = cube_mesh(volume);
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  DiffusionCoefficients coefficients{
      std::vector<double>(cells, absorption), {}, std::vector<char>(cells, 0), {}};
  coefficients.reflectance.assign(static_cast<std::size_t>(mesh.boundary_face_count()), 0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    coefficients.diffusion.push_back((mesh.centroid(CellIndex(c)).x() > 0.5 ? jump : 1) *
                                     Eigen::Matrix3d::Identity());
  return VertexSpace(mesh).assemble([&](CellIndex cell) { return cell_matrix(mesh, coefficients, cell); });
}

Eigen::VectorXd rough(Eigen::Index size, int seed) {
  Eigen::VectorXd x(size);
  for (Eigen::Index i = 0; i < size; ++i) x(i) = std::sin(static_cast<double>((i * i + seed) % 1013));
  return x;
}

/// The largest eigenvalue of I - M A, by the power method: how much of an error one application leaves.
double contraction(const Matrix& lower, const VertexMultigrid& multigrid) {
  const RowMatrix matrix = lower.selfadjointView<Eigen::Lower>();
  Eigen::VectorXd error = rough(matrix.rows(), 1);
  double rate = 0;
  for (int k = 0; k < 15; ++k) {
    error -= multigrid.approximate(matrix * error);
    rate = error.norm();
    error /= rate;
  }
  return rate;
}

TEST(VertexMultigrid, SolvesSmallSystemsExactly) {
  const Matrix lower = cube_matrix(1e-2);
  const VertexMultigrid multigrid(lower);
  EXPECT_EQ(multigrid.level_count(), 1);
  const Eigen::VectorXd right = rough(lower.rows(), 2);
  const Eigen::VectorXd image = lower.selfadjointView<Eigen::Lower>() * multigrid.approximate(right);
  EXPECT_LT((image - right).norm(), 1e-11 * right.norm());
}

TEST(VertexMultigrid, LeavesLittleWhateverTheMeshAndTheJump) {
  for (const double volume : {2e-3, 4e-4})
    for (const double jump : {1e-8, 1e-2, 1.0, 1e6}) {
      const Matrix lower = cube_matrix(volume, jump);
      const VertexMultigrid multigrid(lower, 20);
      EXPECT_GE(multigrid.level_count(), 2);
      EXPECT_LT(contraction(lower, multigrid), 0.3) << "volume " << volume << ", jump " << jump;
    }
}

TEST(VertexMultigrid, LeavesLittleWhereAbsorptionDominates) {
  const Matrix lower = cube_matrix(2.5e-4, 1, 1e8);
  EXPECT_LT(contraction(lower, VertexMultigrid(lower, 20)), 0.3);
}

TEST(VertexMultigrid, NeedsNothingCoarserWhereNothingIsCoupled) {
  Matrix diagonal(50, 50);
  for (int i = 0; i < 50; ++i) diagonal.insert(i, i) = 1 + i;
  const VertexMultigrid multigrid(diagonal, 20);
  EXPECT_EQ(multigrid.level_count(), 2);
  EXPECT_LT(contraction(diagonal, multigrid), 0.1);
}

TEST(VertexMultigrid, IsSymmetricAndPositiveDefinite) {
  const Matrix lower = cube_matrix(1e-3, 1e4, 0.1);
  const VertexMultigrid multigrid(lower, 20);
  ASSERT_GE(multigrid.level_count(), 2);
  const Eigen::VectorXd x = rough(lower.rows(), 3), y = rough(lower.rows(), 5);
  const double forth = x.dot(multigrid.approximate(y)), back = y.dot(multigrid.approximate(x));
  EXPECT_NEAR(forth, back, 1e-12 * x.norm() * multigrid.approximate(y).norm());
  EXPECT_GT(x.dot(multigrid.approximate(x)), 0);
}

TEST(VertexMultigrid, AddsAboutHalfToItsFinestMatrixWhateverTheMesh) {
  for (const double volume : {2e-3, 4e-4, 8e-5})
    EXPECT_LT(VertexMultigrid(cube_matrix(volume), 20).operator_complexity(), 1.6);
}

TEST(VertexMultigrid, RefusesWhatIsNotPositiveDefinite) {
  for (const int direct : {20, 2000})
    EXPECT_THROW(VertexMultigrid(Matrix(-cube_matrix(1e-2)), direct), std::domain_error);
}

TEST(Aggregation, DoesNotReachAcrossAJump) {
  // A chain of six, coupled weakly between the third and the fourth.
  RowMatrix matrix(6, 6);
  const double coupling[] = {1, 1, 1e-6, 1e6, 1e6};
  for (int i = 0; i < 5; ++i) {
    matrix.coeffRef(i, i) += coupling[i];
    matrix.coeffRef(i + 1, i + 1) += coupling[i];
    matrix.coeffRef(i, i + 1) = matrix.coeffRef(i + 1, i) = -coupling[i];
  }
  const Aggregates aggregates = aggregate(matrix, 0.08);
  EXPECT_EQ(aggregates.count, 2);
  EXPECT_EQ(aggregates.of, (std::vector<int>{0, 0, 0, 1, 1, 1}));
}

TEST(Aggregation, LeavesWhatIsCoupledToNothing) {
  RowMatrix matrix(3, 3);
  for (int i = 0; i < 3; ++i) matrix.coeffRef(i, i) = 1;
  matrix.coeffRef(0, 1) = matrix.coeffRef(1, 0) = -0.5;
  const Aggregates aggregates = aggregate(matrix, 0.08);
  EXPECT_EQ(aggregates.of, (std::vector<int>{0, 0, -1}));
  EXPECT_EQ(smoothed_prolongation(matrix, 0).row(2).nonZeros(), 0);
}

TEST(Aggregation, SmoothedFunctionsAddUpToConstants) {
  // Where rows add up to nothing.
  RowMatrix matrix(8, 8);
  for (int i = 0; i < 8; ++i) {
    matrix.coeffRef(i, i) = 2;
    matrix.coeffRef(i, (i + 1) % 8) = matrix.coeffRef((i + 1) % 8, i) = -1;
  }
  const RowMatrix prolongation = smoothed_prolongation(matrix, 0);
  EXPECT_LT(prolongation.cols(), 4);
  const Eigen::VectorXd sum = prolongation * Eigen::VectorXd::Ones(prolongation.cols());
  for (Eigen::Index i = 0; i < 8; ++i) EXPECT_NEAR(sum(i), 1, 1e-14);
}

}  // namespace
}  // namespace etendue::vertex_multigrid_test
