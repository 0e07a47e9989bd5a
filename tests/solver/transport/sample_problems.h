// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/problem.h"
#include "solver/solution/angular_input.h"
#include "solver/transport/solve/solve.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue {

/// The unit cube with a ball of radius 0.3 in its middle as region "ball".
TetrahedralMesh cube_with_ball(double max_volume);

/// The cells of a mesh with its points moved by `map`, oriented again; one region "domain", one wall
/// "boundary".
TetrahedralMesh moved_mesh(const TetrahedralMesh& mesh, const std::function<Vec3(const Vec3&)>& map);
/// The cells of a mesh, each at random in the region "ball" or in "domain"; no walls have names.
TetrahedralMesh random_cells(const TetrahedralMesh& mesh);
/// A mesh and its image in the plane x = 1, joined there.
TetrahedralMesh mesh_with_image(const TetrahedralMesh& mesh);

/// One medium or wall for all bands alike.
Medium uniform_medium(int bands, double absorption, double scattering, double emission,
                      PhaseFunction phase = PhaseIsotropic{});
Wall uniform_wall(int bands, double radiance, double diffuse, double specular);

/// The same medium in all regions and the same wall everywhere.
Problem uniform_problem(const TetrahedralMesh& mesh, const Medium& medium, const Wall& wall);

/// Absorption and scattering [cell][band] [1/length].
std::vector<double> extinction_of(const Problem& problem);

/// The ring of cells turned so that it goes about this unit direction.
TetrahedralMesh cyclic_ring_about(const Vec3& direction);

/// |a - b| / |b| over all values.
double relative_difference(std::span<const double> a, std::span<const double> b);

/// Options that converge far below what a test asks.
SolveOptions tight_options(Lumping lumping = Lumping::none);

/// A radiance u(x, w) and the source w.grad u + sigma_t u that makes it the solution.
class ManufacturedInput : public AngularInput {
 public:
  using Field = std::function<double(const Vec3& point, const Vec3& direction)>;
  ManufacturedInput(const TetrahedralMesh& mesh, const DirectionSet& directions, int bands, Field radiance,
                    Field source)
      : mesh_(mesh),
        directions_(directions),
        bands_(bands),
        radiance_(std::move(radiance)),
        source_(std::move(source)) {}
  void add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override;
  void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const override;

 private:
  const TetrahedralMesh& mesh_;
  const DirectionSet& directions_;
  int bands_;
  Field radiance_;
  Field source_;
};

/// Relative L2 error of the fluence of band 0 against an exact one, by a rule of degree 4 in each cell.
double fluence_error(const TetrahedralMesh& mesh, const Solution& solution, int bands,
                     const std::function<double(const Vec3&)>& exact);
/// Fluence of a radiance that is known at every point and direction. `directions` must outlive it.
std::function<double(const Vec3&)> exact_fluence(const DirectionSet& directions,
                                                 const ManufacturedInput::Field& radiance);
/// Largest |value / expected - 1| over all nodal values.
double largest_deviation(const std::vector<double>& values, double expected);

/// Root mean square of what two fluences differ by in one of `bands` bands, relative to that of b.
double difference(const Solution& a, const Solution& b, std::size_t bands, std::size_t band);

}  // namespace etendue
