// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/diffusion_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "solver/transport/diffusion/vertex_space.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::diffusion_matrix_test {
namespace {

DiffusionCoefficients uniform(const TetrahedralMesh& mesh, double absorption, double diffusion,
                              double reflectance) {
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  return {std::vector<double>(cells, absorption),
          std::vector<Eigen::Matrix3d>(cells, diffusion * Eigen::Matrix3d::Identity()),
          std::vector<char>(cells, 0),
          std::vector<double>(static_cast<std::size_t>(mesh.boundary_face_count()), reflectance)};
}

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  const Eigen::Index size = 4 * matrix.cell_count();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
  for (std::int32_t c = 0; c < matrix.cell_count(); ++c) {
    result.block<4, 4>(4 * c, 4 * c) = matrix.diagonal(CellIndex(c));
    for (std::size_t f = 0; f < 4; ++f)
      if (const std::int32_t n = matrix.neighbour(CellIndex(c), f); n >= 0)
        result.block<4, 4>(4 * c, 4 * n) = matrix.behind(CellIndex(c), f);
  }
  return result;
}

/// Coefficients that jump by orders of magnitude from cell to cell, tensors and lumped cells among them.
DiffusionCoefficients wild(const TetrahedralMesh& mesh, double reflectance) {
  DiffusionCoefficients coefficients = uniform(mesh, 0, 1, reflectance);
  for (std::size_t c = 0; c < coefficients.absorption.size(); ++c) {
    const double contrast = std::pow(10.0, static_cast<double>(c * 7 % 5) - 3);
    const Vec3 axis =
        Vec3(std::sin(static_cast<double>(c)), std::cos(static_cast<double>(c)), 0.3).normalized();
    coefficients.diffusion[c] = contrast * (Eigen::Matrix3d::Identity() * 0.2 + 2 * axis * axis.transpose());
    coefficients.lumped[c] = c % 3 == 0;
  }
  return coefficients;
}

class EveryWall : public testing::TestWithParam<double> {};

TEST_P(EveryWall, MatrixIsSymmetricAndPositiveDefinite) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  for (const double thickness : {0.1, 1.0, 30.0, 1000.0}) {
    DiffusionCoefficients coefficients = uniform(mesh, 0, 0.1 / (3 * thickness), GetParam());
    const Eigen::MatrixXd matrix = dense(diffusion_matrix(mesh, coefficients));
    EXPECT_LT((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 1e-15 * matrix.cwiseAbs().maxCoeff());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()(0),
              0);
  }
  const Eigen::MatrixXd matrix = dense(diffusion_matrix(mesh, wild(mesh, GetParam())));
  EXPECT_LT((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 1e-14 * matrix.cwiseAbs().maxCoeff());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()(0),
            0);
}
INSTANTIATE_TEST_SUITE_P(DiffusionMatrix, EveryWall, testing::Values(0.0, 0.3, 0.95));

TEST(DiffusionMatrix, LinearFunctionsFluxesAreConsistent) {
  // With D constant and phi linear, div D grad phi = 0: rows of functions that do not touch a wall vanish,
  // and jumps add nothing. With mirrors all around the sum over all rows is the outflow, zero.
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const BlockMatrix matrix = diffusion_matrix(mesh, uniform(mesh, 0, 0.7, 1));
  NodalVector phi, image(static_cast<std::size_t>(4 * mesh.cell_count()));
  for (const auto& cell : mesh.cell_vertices())
    for (const std::int32_t v : cell) phi.push_back(1 + mesh.point(VertexIndex(v)).dot(Vec3(1, -2, 0.5)));
  matrix.multiply(phi, image, 1);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    bool touches = false;
    for (const std::int32_t f : mesh.faces(CellIndex(c))) touches = touches || f < mesh.boundary_face_count();
    for (std::size_t i = 0; !touches && i < 4; ++i)
      EXPECT_NEAR(image[4 * static_cast<std::size_t>(c) + i], 0, 1e-14);
  }
}

TEST(DiffusionMatrix, ConstantsLoseOnlyWhatIsAbsorbedAndLeaves) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const double reflectance = 0.4;
  const BlockMatrix matrix = diffusion_matrix(mesh, uniform(mesh, 0.3, 0.7, reflectance));
  const NodalVector one(static_cast<std::size_t>(4 * mesh.cell_count()), 1);
  NodalVector image(one.size());
  matrix.multiply(one, image, 1);
  double sum = 0;
  for (const double value : image) sum += value;
  EXPECT_NEAR(sum, 0.3 + 6 * 0.5 * (1 - reflectance) / (1 + reflectance), 1e-12);
}

TEST(DiffusionMatrix, OnContinuousFunctionsTheCellsAloneAreLeft) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const DiffusionCoefficients coefficients = wild(mesh, 0);
  const BlockMatrix matrix = diffusion_matrix(mesh, coefficients);
  const VertexSpace vertices(mesh);
  const Eigen::SparseMatrix<double> coarse =
      vertices.assemble([&](CellIndex cell) { return cell_matrix(mesh, coefficients, cell); });
  Eigen::VectorXd x(vertices.size()), expected(vertices.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) x(i) = std::sin(3.0 * static_cast<double>(i));
  NodalVector nodal(static_cast<std::size_t>(4 * mesh.cell_count()), 0), image(nodal.size());
  vertices.add_spread({x.data(), static_cast<std::size_t>(x.size())}, nodal, 1);
  matrix.multiply(nodal, image, 1);
  vertices.gather(image, {expected.data(), static_cast<std::size_t>(expected.size())});
  const Eigen::VectorXd direct = coarse.selfadjointView<Eigen::Lower>() * x;
  EXPECT_LT((direct - expected).norm(), 1e-13 * expected.norm());
}

}  // namespace
}  // namespace etendue::diffusion_matrix_test
