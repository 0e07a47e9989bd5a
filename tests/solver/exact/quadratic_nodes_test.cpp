// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/exact/quadratic_nodes.h"

#include <gtest/gtest.h>

#include "base/quadrature/cell_rule.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::quadratic_nodes_test {
namespace {

double linear(const Vec3& p) { return 2 + p.x() - 3 * p.y() + 0.5 * p.z(); }
double quadratic(const Vec3& p) { return linear(p) + p.x() * p.y() - 2 * p.z() * p.z() + p.x() * p.z(); }

template <std::size_t N, class Function>
std::array<double, N> sampled(const QuadraticNodes& nodes, const std::array<std::size_t, N>& at, Function f) {
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) values[i] = f(nodes.point(at[i]));
  return values;
}

TEST(QuadraticNodes, KeepLinearFunctions) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const QuadraticNodes nodes(mesh);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const auto found = project(sampled(nodes, nodes.nodes(CellIndex(c)), linear));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(found[i], linear(mesh.point(VertexIndex(mesh.vertices(CellIndex(c))[i]))), 1e-14);
  }
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const auto found = project(sampled(nodes, nodes.nodes(FaceIndex(f)), linear));
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(found[i], linear(mesh.point(VertexIndex(mesh.vertices(FaceIndex(f))[i]))), 1e-14);
  }
}

TEST(QuadraticNodes, AreThoseOfAllEdgesOnce) {
  // Euler: vertices - edges + faces - cells = 1 for a ball.
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const auto edges = static_cast<int>(QuadraticNodes(mesh).count()) - mesh.vertex_count();
  EXPECT_EQ(mesh.vertex_count() - edges + mesh.face_count() - mesh.cell_count(), 1);
}

TEST(QuadraticNodes, ProjectQuadraticsSoThatWhatIsLeftIsOrthogonalToLinearFunctions) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const QuadraticNodes nodes(mesh);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
    const auto found = project(sampled(nodes, nodes.nodes(cell), quadratic));
    std::array<double, 4> left{};
    for (const CellRulePoint& node : cell_rule()) {
      double difference = quadratic(point_at(node.barycentric, corners));
      for (std::size_t i = 0; i < 4; ++i) difference -= node.barycentric[i] * found[i];
      for (std::size_t i = 0; i < 4; ++i) left[i] += node.weight * node.barycentric[i] * difference;
    }
    for (const double part : left) EXPECT_NEAR(part, 0, 1e-14);
  }
}

TEST(QuadraticNodes, ProjectOnFacesWithTheMeanOfTheQuadratic) {
  // The midpoints of the edges integrate quadratics over a triangle exactly.
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const QuadraticNodes nodes(mesh);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const auto values = sampled(nodes, nodes.nodes(FaceIndex(f)), quadratic);
    const auto found = project(values);
    EXPECT_NEAR(found[0] + found[1] + found[2], values[3] + values[4] + values[5], 1e-13);
  }
}

}  // namespace
}  // namespace etendue::quadratic_nodes_test
