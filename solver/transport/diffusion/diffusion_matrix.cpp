// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/diffusion_matrix.h"

#include <algorithm>

namespace etendue {
namespace {

/// Penalty constant C. With 2, the usual value for diffusion, the accelerated iteration diverges on
/// tetrahedra (docs/theory/iteration.md).
constexpr double penalty = 4;

/// Of isotropic light of fluence 1 through a face, one way.
double partial_current_along(const DiffusionCoefficients& coefficients, const Vec3& normal) {
  return coefficients.partial_current * (coefficients.is_plane ? normal.head<2>().norm() : 1);
}

/// A face as one of its cells sees it.
struct FaceSide {
  CellIndex cell;
  std::size_t corner;     ///< the vertex that lies opposite
  double sign;            ///< of its value in the jump u+ - u-
  Eigen::Vector4d slope;  ///< n.D grad lambda_i, n from - to +
  double conductance;     ///< n.D n
  double height;          ///< h = 3 V / A
  double weight = 0.5;    ///< of its flux in the mean
};

std::size_t corner_opposite(const TetrahedralMesh& mesh, CellIndex cell, FaceIndex face) {
  const auto& faces = mesh.faces(cell);
  return static_cast<std::size_t>(std::find(faces.begin(), faces.end(), face.value()) - faces.begin());
}

FaceSide face_side(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients, CellIndex cell,
                   FaceIndex face, double sign) {
  const Vec3 normal = mesh.area_normal(face).normalized();
  const Vec3 conormal = coefficients.diffusion[cell.at()] * normal;
  const double height = 3 * mesh.volume(cell) / mesh.area(face);
  return {cell,
          corner_opposite(mesh, cell, face),
          sign,
          barycentric_gradients(mesh, cell).transpose() * conormal,
          normal.dot(conormal),
          height};
}

/// 1 for vertices on the face, 0 for the one opposite.
Eigen::Vector4d on_face(std::size_t corner) {
  Eigen::Vector4d flags = Eigen::Vector4d::Ones();
  flags(static_cast<Eigen::Index>(corner)) = 0;
  return flags;
}

/// Integral of lambda_i mu_j over the face, which both cells meet in the same order of its vertices.
Eigen::Matrix4d face_mass(double area, std::size_t row_corner, std::size_t column_corner) {
  Eigen::Matrix4d result = area / 12 * on_face(row_corner) * on_face(column_corner).transpose();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Index i = k < static_cast<Eigen::Index>(row_corner) ? k : k + 1;
    const Eigen::Index j = k < static_cast<Eigen::Index>(column_corner) ? k : k + 1;
    result(i, j) += area / 12;
  }
  return result;
}

/// Weighted means (Ern, Stephansen and Zunino 2009): the flux through a face is that of the worse conductor,
/// so that a void does not stiffen what lies beside it. Returns the penalty, of harmonic means too.
double weigh(FaceSide& minus, FaceSide& plus, double partial_current) {
  const double conductance = minus.conductance + plus.conductance;
  if (conductance > 0) minus.weight = plus.conductance / conductance;
  plus.weight = 1 - minus.weight;
  const auto part = [](const FaceSide& side) {
    return side.weight * side.weight * side.conductance / side.height;
  };
  // Upwind transport itself does the least to a jump: its partial current.
  return std::max(partial_current, 4 * penalty * (part(minus) + part(plus)));
}

/// kappa ([[u]], [[v]]) + ([[u]], {{D dn v}}) + ({{D dn u}}, [[v]]) with v on `row` and u on `column`.
Eigen::Matrix4d jump_block(double area, double kappa, const FaceSide& row, const FaceSide& column) {
  const double third = area / 3;
  return kappa * row.sign * column.sign * face_mass(area, row.corner, column.corner) +
         row.weight * third * column.sign * row.slope * on_face(column.corner).transpose() +
         column.weight * third * row.sign * on_face(row.corner) * column.slope.transpose();
}

/// Wall terms of (D7). Black: kappa_b (u, v) - (u, D dn v)/2 - (D dn u, v)/2. Reflecting: the Robin term
/// (1 - alpha)/(1 + alpha)/2 (u, v) alone, since scaling kappa_b alone makes the form indefinite.
Eigen::Matrix4d wall_block(double area, double reflectance, double partial_current, const FaceSide& side) {
  const Eigen::Matrix4d mass = face_mass(area, side.corner, side.corner);
  if (reflectance > 0) return 2 * partial_current * (1 - reflectance) / (1 + reflectance) * mass;
  const double kappa = std::max(partial_current, 2 * penalty * side.conductance / side.height);
  const Eigen::Matrix4d flux = area / 3 * side.slope * on_face(side.corner).transpose();
  return kappa * mass - 0.5 * (flux + flux.transpose());
}

void add_interior_face(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients, FaceIndex face,
                       BlockMatrix& matrix) {
  FaceSide minus = face_side(mesh, coefficients, mesh.owner(face), face, -1);
  FaceSide plus = face_side(mesh, coefficients, mesh.neighbour(face), face, 1);
  const double area = mesh.area(face);
  const double kappa = weigh(minus, plus, partial_current_along(coefficients, mesh.area_normal(face) / area));
  matrix.diagonal(minus.cell) += jump_block(area, kappa, minus, minus);
  matrix.diagonal(plus.cell) += jump_block(area, kappa, plus, plus);
  matrix.behind(minus.cell, minus.corner) = jump_block(area, kappa, minus, plus);
  matrix.behind(plus.cell, plus.corner) = jump_block(area, kappa, plus, minus);
}

}  // namespace

Eigen::Matrix4d mass_matrix(double volume, bool lumped) {
  if (lumped) return volume / 4 * Eigen::Matrix4d::Identity();
  return volume / 20 * (Eigen::Matrix4d::Identity() + Eigen::Matrix4d::Ones());
}

Eigen::Matrix<double, 3, 4> barycentric_gradients(const TetrahedralMesh& mesh, CellIndex cell) {
  Eigen::Matrix<double, 3, 4> gradients;
  for (std::size_t i = 0; i < 4; ++i) {
    const FaceIndex face(mesh.faces(cell)[i]);
    const double side = mesh.owner(face) == cell ? 1 : -1;
    gradients.col(static_cast<Eigen::Index>(i)) = -side / (3 * mesh.volume(cell)) * mesh.area_normal(face);
  }
  return gradients;
}

Eigen::Matrix4d cell_matrix(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients,
                            CellIndex cell) {
  const std::size_t c = cell.at();
  const Eigen::Matrix<double, 3, 4> gradients = barycentric_gradients(mesh, cell);
  Eigen::Matrix4d matrix =
      coefficients.absorption[c] * mass_matrix(mesh.volume(cell), coefficients.lumped[c] != 0) +
      mesh.volume(cell) * gradients.transpose() * coefficients.diffusion[c] * gradients;
  for (const std::int32_t f : mesh.faces(cell)) {
    if (f >= mesh.boundary_face_count()) continue;
    const FaceIndex face(f);
    matrix += wall_block(mesh.area(face), coefficients.reflectance[face.at()], coefficients.partial_current,
                         face_side(mesh, coefficients, cell, face, -1));
  }
  return matrix;
}

CellMatrices cell_matrices(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients) {
  CellMatrices matrices;
  matrices.reserve(static_cast<std::size_t>(mesh.cell_count()));
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    matrices.push_back(cell_matrix(mesh, coefficients, CellIndex(c)));
  return matrices;
}

BlockMatrix diffusion_matrix(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients) {
  return diffusion_matrix(mesh, coefficients, cell_matrices(mesh, coefficients));
}

BlockMatrix diffusion_matrix(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients,
                             const CellMatrices& matrices) {
  BlockMatrix matrix(mesh);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    matrix.diagonal(CellIndex(c)) = matrices[CellIndex(c).at()];
  for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f)
    add_interior_face(mesh, coefficients, FaceIndex(f), matrix);
  return matrix;
}

}  // namespace etendue
