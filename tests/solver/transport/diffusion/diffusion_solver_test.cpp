// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/diffusion_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::diffusion_solver_test {
namespace {

DiffusionCoefficients uniform(const TetrahedralMesh& mesh, double absorption, double diffusion,
                              double reflectance) {
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  return {std::vector<double>(cells, absorption),
          std::vector<Eigen::Matrix3d>(cells, diffusion * Eigen::Matrix3d::Identity()),
          std::vector<char>(cells, 0),
          std::vector<double>(static_cast<std::size_t>(mesh.boundary_face_count()), reflectance)};
}

NodalVector right_of(const TetrahedralMesh& mesh, const std::function<double(const Vec3&)>& source) {
  NodalVector right;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    Eigen::Vector4d values;
    for (std::size_t i = 0; i < 4; ++i)
      values(static_cast<Eigen::Index>(i)) = source(mesh.point(VertexIndex(mesh.vertices(CellIndex(c))[i])));
    const Eigen::Vector4d row = mass_matrix(mesh.volume(CellIndex(c)), false) * values;
    right.insert(right.end(), row.data(), row.data() + 4);
  }
  return right;
}

/// With mirrors, D = 1 and sigma_a = 1, phi = cos(pi x) cos(pi y) solves it for the source (1 + 2 pi^2) phi.
double exact(const Vec3& at) { return std::cos(M_PI * at.x()) * std::cos(M_PI * at.y()); }

double solution_error(const TetrahedralMesh& mesh, const NodalVector& phi) {
  double error = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const std::size_t at = 4 * static_cast<std::size_t>(c);
    const double mean = (phi[at] + phi[at + 1] + phi[at + 2] + phi[at + 3]) / 4;
    error += mesh.volume(CellIndex(c)) * std::pow(mean - exact(mesh.centroid(CellIndex(c))), 2);
  }
  return std::sqrt(error);
}

TEST(DiffusionSolver, ConvergesWithOrderTwo) {
  std::vector<double> errors;
  for (const double volume : {1e-2, 1.25e-3, 1.5625e-4}) {
    const TetrahedralMesh mesh = cube_mesh(volume);
    const VertexSpace vertices(mesh);
    const DiffusionSolver solver(mesh, vertices, uniform(mesh, 1, 1, 1), 0.5, 1);
    const NodalVector right =
        right_of(mesh, [](const Vec3& at) { return (1 + 2 * M_PI * M_PI) * exact(at); });
    NodalVector phi(right.size());
    EXPECT_LT(solver.solve(right, phi, 1e-10, 60), 40);
    errors.push_back(solution_error(mesh, phi));
  }
  EXPECT_GT(std::log2(errors[0] / errors[2]) / 2, 1.8);
}

TEST(DiffusionSolver, IterationsGrowNeitherWithTheMeshNorWithThickness) {
  for (const double volume : {1e-2, 3e-4})
    for (const double thickness : {0.1, 1.0, 10.0, 1000.0}) {
      const TetrahedralMesh mesh = cube_mesh(volume);
      const VertexSpace vertices(mesh);
      const double size = std::cbrt(volume);
      const DiffusionSolver solver(mesh, vertices, uniform(mesh, 0, size / (3 * thickness), 0), 0.5, 1);
      const NodalVector right = right_of(mesh, [](const Vec3& at) { return at.x() > 0.5 ? 1.0 : 0.0; });
      NodalVector phi(right.size()), image(right.size());
      const int iterations = solver.solve(right, phi, 1e-8, 60);
      EXPECT_LE(iterations, 25) << "thickness " << thickness << ", volume " << volume;
      solver.matrix().residual(right, phi, image, 1);
      EXPECT_LT(std::sqrt(ordered_dot(image, image, 1) / ordered_dot(right, right, 1)), 1e-6);
    }
}

TEST(DiffusionSolver, CycleIsSymmetric) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const VertexSpace vertices(mesh);
  const DiffusionSolver solver(mesh, vertices, uniform(mesh, 0.1, 0.01, 0), 0.5, 1);
  NodalVector x(static_cast<std::size_t>(4 * mesh.cell_count())), y(x.size()), cycle_x(x.size()),
      cycle_y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::sin(static_cast<double>(7 * i));
    y[i] = std::cos(static_cast<double>(i * i));
  }
  solver.precondition(x, cycle_x);
  solver.precondition(y, cycle_y);
  EXPECT_NEAR(ordered_dot(cycle_x, y, 1) / ordered_dot(x, cycle_y, 1), 1, 1e-11);
  EXPECT_GT(ordered_dot(cycle_x, x, 1), 0);
}

TEST(DiffusionSolver, ApproximationIsLinearAndAsAccurateAsAsked) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const VertexSpace vertices(mesh);
  for (const double accuracy : {0.5, 0.05}) {
    const DiffusionSolver solver(mesh, vertices, uniform(mesh, 0.1, 0.01, 0), accuracy, 1);
    const NodalVector a = right_of(mesh, [](const Vec3& at) { return at.x() > 0.3 ? 1.0 : 0.0; });
    const NodalVector b = right_of(mesh, [](const Vec3& at) { return std::sin(20 * at.y()); });
    NodalVector sum(a), of_a(a.size()), of_b(a.size()), of_sum(a.size()), error(a.size()), image(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) sum[i] += 3 * b[i];
    solver.approximate(a, of_a);
    solver.approximate(b, of_b);
    solver.approximate(sum, of_sum);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(of_sum[i], of_a[i] + 3 * of_b[i], 1e-12);
    solver.solve(a, error, 1e-12, 100);
    solver.matrix().multiply(error, image, 1);
    const double size = ordered_dot(error, image, 1);
    for (std::size_t i = 0; i < a.size(); ++i) error[i] -= of_a[i];
    solver.matrix().multiply(error, image, 1);
    EXPECT_LT(std::sqrt(ordered_dot(error, image, 1) / size), accuracy);
  }
}

TEST(DiffusionSolver, PolynomialHasABoundedLength) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const VertexSpace vertices(mesh);
  EXPECT_EQ(DiffusionSolver(mesh, vertices, uniform(mesh, 0.1, 0.01, 0), 1e-30, 1).steps(),
            longest_polynomial);
}

TEST(DiffusionSolver, RefusesWhatIsNotPositiveDefinite) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const VertexSpace vertices(mesh);
  const auto solver = [&](double absorption, double diffusion, double reflectance) {
    return DiffusionSolver(mesh, vertices, uniform(mesh, absorption, diffusion, reflectance), 0.5, 1);
  };
  EXPECT_NO_THROW(solver(1e-8, 1, 1));
  EXPECT_THROW(solver(0, 1, 1), std::domain_error);
  EXPECT_THROW(solver(1e-17, 1, 1), std::domain_error) << "a loss that rounding swallows";
  EXPECT_THROW(solver(1, NAN, 1), std::domain_error);
  EXPECT_THROW(solver(1, HUGE_VAL, 0), std::domain_error);
  EXPECT_THROW(solver(1, -1, 1), std::domain_error);
}

TEST(DiffusionSolver, MeasuresItsCycleOnASingleCell) {
  RawMesh raw;
  raw.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  raw.cells = {{0, 1, 2, 3}};
  raw.cell_regions = {0};
  raw.region_names = {"domain"};
  const TetrahedralMesh mesh(raw);
  const VertexSpace vertices(mesh);
  EXPECT_EQ(DiffusionSolver(mesh, vertices, uniform(mesh, 1, 1, 0), 0.5, 1).steps(), 1);
}

TEST(DiffusionSolver, SameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(1e-3);
  const VertexSpace vertices(mesh);
  const NodalVector right = right_of(mesh, [](const Vec3& at) { return at.y(); });
  NodalVector one(right.size()), many(right.size());
  DiffusionSolver(mesh, vertices, uniform(mesh, 0, 0.1, 0), 0.5, 1).solve(right, one, 1e-6, 50);
  for (const int threads : {2, 3}) {
    DiffusionSolver(mesh, vertices, uniform(mesh, 0, 0.1, 0), 0.5, threads).solve(right, many, 1e-6, 50);
    EXPECT_EQ(many, one);
  }
}

TEST(DiffusionSolver, RefusesWhatHasNoSteadyState) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const VertexSpace vertices(mesh);
  EXPECT_THROW(DiffusionSolver(mesh, vertices, uniform(mesh, 0, 1, 1), 0.5, 1), std::domain_error);
}

}  // namespace
}  // namespace etendue::diffusion_solver_test
