// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/gray_diffusion.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/blackbody.h"
#include "mesh/tetrahedra/bounding_box.h"
#include "solver/materials/phase/phase_function.h"
#include "solver/problem/band_blackbody.h"
#include "solver/transport/diffusion/diffusion_matrix.h"
#include "solver/transport/diffusion/diffusion_solver.h"

namespace etendue {
namespace {

using std::numbers::pi;

constexpr double tolerance = 1e-5;  ///< relative, of a system that only preconditions
constexpr int most_iterations = 500;
constexpr double dropped = 1e-4;  ///< entries of the factors, relative to their row
constexpr int fill = 12;          ///< entries of the factors for each of the matrix
/// Absorption over D/size^2 that keeps the system regular where nothing absorbs and nothing leaves.
constexpr double least_absorption = 1e-8;

/// Part of the emission of all bands for each kelvin, of what emits least.
constexpr double least_slope = 1e-3;

/// Absorption lengths in a cell above which light jumps between cells.
constexpr double thick = 2;
constexpr double accuracy_of_jumps = 0.1;

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

std::size_t unknown_of(const TemperatureSpace& space, CellIndex cell, std::size_t i) {
  return static_cast<std::size_t>(space.unknown(cell, i));
}

/// Whether the temperatures of a cell are eliminated: those of a medium that does not conduct.
bool eliminates(const TemperatureSpace& space, CellIndex cell) {
  return space.has(cell) && !space.conducts(cell);
}

/// Assembles the system row by row. Temperatures are in units of `kelvin`, so that all unknowns are alike.
class GraySystem {
 public:
  GraySystem(std::size_t temperatures, std::size_t vertices, double kelvin)
      : temperatures_(temperatures),
        kelvin_(kelvin),
        right_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(temperatures + vertices))) {}

  std::size_t fluence(std::int32_t vertex) const { return temperatures_ + static_cast<std::size_t>(vertex); }
  void add(std::size_t row, std::size_t column, double value) {
    if (column < temperatures_) value *= kelvin_;
    entries_.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  }
  void add_right(std::size_t row, double value) { right_[static_cast<Eigen::Index>(row)] += value; }

  /// Temperatures [K], then fluences [W/m^2].
  Eigen::VectorXd solve() const {
    Eigen::SparseMatrix<double> matrix(right_.size(), right_.size());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    Eigen::BiCGSTAB<Eigen::SparseMatrix<double>, Eigen::IncompleteLUT<double>> solver;
    solver.preconditioner().setDroptol(dropped);
    solver.preconditioner().setFillfactor(fill);
    solver.setTolerance(tolerance);
    solver.setMaxIterations(most_iterations);
    solver.compute(matrix);
    Eigen::VectorXd solution = solver.solve(right_);
    solution.head(static_cast<Eigen::Index>(temperatures_)) *= kelvin_;
    return solution;
  }

 private:
  std::size_t temperatures_;
  double kelvin_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_;
};

/// Bands of a cell in which more light goes further weigh more.
class GrayCells {
 public:
  GrayCells(const Problem& problem, const TemperatureSpace& space, const Blackbodies& blackbodies,
            double usual_temperature, double longest_path)
      : problem_(problem), space_(space), blackbodies_(blackbodies), longest_path_(longest_path) {
    for (int band = 0; band < problem.band_count(); ++band)
      usual_slope_.push_back(band_blackbody_slope(problem.bands(), band, usual_temperature));
  }

  GrayCell at(CellIndex cell) const {
    const auto bands = static_cast<std::size_t>(problem_.band_count());
    GrayCell gray;
    std::vector<double> more(bands);  // light for a kelvin
    for (std::size_t band = 0; band < bands; ++band) {
      const double absorption = problem_.absorption(cell, static_cast<int>(band));
      for (std::size_t i = 0; i < 4 && space_.has(cell); ++i)
        gray.emission[i] += 4 * pi * absorption * slope(cell, i, band);
      for (std::size_t i = 0; i < 4; ++i) more[band] += slope(cell, i, band) / 4;
    }
    gray.share = more;
    for (std::size_t band = 0; band < bands; ++band)
      gray.share[band] *=
          problem_.absorption(cell, static_cast<int>(band)) * path(cell, static_cast<int>(band));
    if (std::accumulate(gray.share.begin(), gray.share.end(), 0.0) <= 0) gray.share = more;
    double sum = std::accumulate(gray.share.begin(), gray.share.end(), 0.0);
    if (sum <= 0) {
      gray.share.assign(bands, 1);
      sum = static_cast<double>(bands);
    }
    for (std::size_t band = 0; band < bands; ++band) {
      gray.share[band] /= sum;
      gray.absorption += gray.share[band] * problem_.absorption(cell, static_cast<int>(band));
      gray.diffusion += gray.share[band] * path(cell, static_cast<int>(band)) / 3;
    }
    return gray;
  }

 private:
  double slope(CellIndex cell, std::size_t i, std::size_t band) const {
    if (!space_.has(cell)) return usual_slope_[band];
    const auto bands = static_cast<std::size_t>(problem_.band_count());
    return blackbodies_.slope[unknown_of(space_, cell, i) * bands + band];
  }

  /// Free path to absorption or a change of direction [m].
  double path(CellIndex cell, int band) const {
    const Medium& medium = problem_.medium(problem_.mesh().region(cell));
    const double turned =
        1 - (medium.is_directional(band) ? 0 : phase_asymmetry(medium.phase[static_cast<std::size_t>(band)]));
    return 1 / std::max(problem_.absorption(cell, band) + turned * problem_.scattering(cell, band),
                        1 / longest_path_);
  }

  const Problem& problem_;
  const TemperatureSpace& space_;
  const Blackbodies& blackbodies_;
  double longest_path_;
  std::vector<double> usual_slope_;  ///< [band]
};

/// Integrals of the gradients of the four vertices' functions by each other, times a coefficient.
Eigen::Matrix4d stiffness(const TetrahedralMesh& mesh, CellIndex cell, double coefficient) {
  const Eigen::Matrix<double, 3, 4> slopes = barycentric_gradients(mesh, cell);
  return mesh.volume(cell) * coefficient * slopes.transpose() * slopes;
}

/// Adds the rows of a cell. What does not conduct sends out again what it absorbs and gains and does not
/// store.
void add_cell(const TetrahedralMesh& mesh, const TemperatureSpace& space, CellIndex cell, double conductivity,
              const GrayCell& gray, const EliminatedCell& eliminated, double floor,
              std::span<const double> gains, GraySystem& system) {
  const double quarter = mesh.volume(cell) / 4;
  const Eigen::Matrix4d diffusion = stiffness(mesh, cell, gray.diffusion);
  const Eigen::Matrix4d conduction = stiffness(mesh, cell, conductivity);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t light = system.fluence(mesh.vertices(cell)[i]);
    for (std::size_t k = 0; k < 4; ++k)
      system.add(light, system.fluence(mesh.vertices(cell)[k]), diffusion(at(i), at(k)));
    system.add(light, light, quarter * floor);
    if (eliminates(space, cell)) {
      const double emitted = eliminated[i].emitted_part();
      system.add_right(light, emitted * gains[unknown_of(space, cell, i)]);
      system.add(light, light, (1 - emitted) * eliminated[i].absorbing);
      continue;
    }
    system.add(light, light, quarter * gray.absorption);
    if (!space.has(cell)) continue;
    const std::size_t unknown = unknown_of(space, cell, i);
    system.add(unknown, unknown, quarter * gray.emission[i]);
    system.add(unknown, light, -quarter * gray.absorption);
    system.add(light, unknown, -quarter * gray.emission[i]);
    for (std::size_t k = 0; k < 4; ++k)
      system.add(unknown, unknown_of(space, cell, k), conduction(at(i), at(k)));
  }
}

/// Adds what flows into a wall that has a temperature, (T0).
void add_held_face(const TemperatureSpace& space, const HeldFace& held, double conductivity,
                   std::span<const double> temperature, GraySystem& system) {
  const double third = held.area / 3 * conductivity;
  const auto add = [&](std::size_t row, std::size_t column, double value) {
    system.add(row, column, value * space.kelvin_per_value(column, temperature[column]));
  };
  const auto add_both = [&](std::size_t one, std::size_t other, double value) {
    add(one, other, value);
    add(other, one, value);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t inside = unknown_of(space, held.cell, held.corners[k]);
    add(inside, inside, third * held.penalty);
    for (std::size_t i = 0; i < 4; ++i)
      add_both(inside, unknown_of(space, held.cell, i), -third * held.normal_slope[i]);
    if (held.unknowns[k] < 0) continue;
    const auto wall = static_cast<std::size_t>(held.unknowns[k]);
    add(wall, wall, third * held.penalty);
    add_both(wall, inside, -third * held.penalty);
    for (std::size_t i = 0; i < 4; ++i)
      add_both(wall, unknown_of(space, held.cell, i), third * held.normal_slope[i]);
  }
}

double mean_reflectance(const Problem& problem, FaceIndex face, const std::vector<double>& share) {
  const Wall& wall = problem.wall(problem.mesh().wall(face));
  double reflectance = 0;
  for (std::size_t band = 0; band < share.size(); ++band)
    reflectance += share[band] * wall.mean_reflectance(band);
  return reflectance;
}

/// Adds the light that leaves by a wall (Marshak 1947).
void add_wall_face(const Problem& problem, FaceIndex face, const std::vector<double>& share,
                   GraySystem& system) {
  const TetrahedralMesh& mesh = problem.mesh();
  const double reflectance = mean_reflectance(problem, face, share);
  const double leaving = (1 - reflectance) / (1 + reflectance) / 2;
  for (const std::int32_t vertex : mesh.vertices(face))
    system.add(system.fluence(vertex), system.fluence(vertex), mesh.area(face) / 3 * leaving);
}

/// Adds the rows of a face whose temperature follows. With the reflectance rho it sends j = rho H + w t, and
/// F/2 = H + j: so it absorbs (1 - rho) H = ((1 - rho) F/2 - (1 - rho) w t)/(1 + rho). `kelvin` are the
/// changes of the temperatures with the values of the unknowns.
void add_following_face(const Problem& problem, const WallHeat& walls, const FollowingFace& face,
                        const std::vector<double>& share, const Blackbodies& blackbodies,
                        const std::array<double, 3>& kelvin, GraySystem& system) {
  const TetrahedralMesh& mesh = problem.mesh();
  const double third = mesh.area(face.face) / 3;
  const double reflectance = mean_reflectance(problem, face.face, share);
  const bool is_smooth = problem.wall(mesh.wall(face.face)).refractive_index != 1;
  const double absorbed = is_smooth ? 0 : (1 - reflectance) / (1 + reflectance) / 2;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t unknown = face.unknowns[i];
    const std::size_t light = system.fluence(mesh.vertices(face.face)[i]);
    const double emitted = 2 * walls.emission_slope(face, i, blackbodies) / (1 + reflectance);
    system.add(unknown, unknown, third * (walls.convection_slope(face) * kelvin[i] + emitted));
    system.add(unknown, light, -third * absorbed);
    system.add(light, unknown, -third * emitted);
  }
}

}  // namespace

GrayDiffusion::GrayDiffusion(const Problem& problem, const TemperatureSpace& space,
                             const HeatBalance& balance)
    : problem_(problem),
      space_(space),
      balance_(balance),
      longest_path_(bounding_box(problem.mesh().points()).diagonal()) {}

std::vector<double> GrayDiffusion::changes(std::span<const double> temperature,
                                           const Blackbodies& blackbodies, std::span<const double> gains,
                                           std::span<const double> inertia) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const double highest = highest_temperature(temperature);
  const double kelvin = 1 / (16 * stefan_boltzmann * std::pow(highest, 3));
  const GrayCells gray(problem_, space_, blackbodies, highest, longest_path_);
  std::vector<GrayCell> cells;
  std::vector<EliminatedCell> eliminated;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    cells.push_back(gray.at(CellIndex(c)));
    eliminated.push_back(eliminated_at(CellIndex(c), cells.back(), temperature, inertia));
  }
  GraySystem system(space_.unknowns_before_cells(), static_cast<std::size_t>(mesh.vertex_count()), kelvin);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const CellIndex cell(static_cast<std::int32_t>(c));
    add_cell(mesh, space_, cell, balance_.conduction().conductivity(cell), cells[c], eliminated[c],
             floor_of(cells[c]), gains, system);
  }
  for (std::size_t unknown = 0; unknown < space_.unknowns_before_cells(); ++unknown) {
    system.add_right(unknown, gains[unknown]);
    system.add(unknown, unknown, inertia[unknown] * space_.kelvin_per_value(unknown, temperature[unknown]));
  }
  for (const HeldFace& held : balance_.conduction().held_faces())
    add_held_face(space_, held, balance_.conduction().conductivity(held.cell), temperature, system);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    add_wall_face(problem_, FaceIndex(f), cells[mesh.owner(FaceIndex(f)).at()].share, system);
  for (const FollowingFace& face : balance_.walls().faces()) {
    std::array<double, 3> per_value;
    for (std::size_t i = 0; i < 3; ++i)
      per_value[i] = space_.kelvin_per_value(face.unknowns[i], temperature[face.unknowns[i]]);
    add_following_face(problem_, balance_.walls(), face, cells[mesh.owner(face.face).at()].share, blackbodies,
                       per_value, system);
  }
  const Eigen::VectorXd solution = system.solve();
  const NodalVector light = light_of(solution, cells, eliminated, gains);
  std::vector<double> changes(space_.size(), 0);
  for (std::size_t i = 0; i < space_.unknowns_before_cells(); ++i) changes[i] = solution[at(i)];
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const CellIndex cell(static_cast<std::int32_t>(c));
    if (!eliminates(space_, cell)) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t unknown = unknown_of(space_, cell, i);
      changes[unknown] = eliminated[c][i].change(gains[unknown], light[4 * c + i]);
    }
  }
  return changes;
}

EliminatedCell GrayDiffusion::eliminated_at(CellIndex cell, const GrayCell& gray,
                                            std::span<const double> temperature,
                                            std::span<const double> inertia) const {
  EliminatedCell result = {};
  const double quarter = problem_.mesh().volume(cell) / 4;
  for (std::size_t i = 0; i < 4 && eliminates(space_, cell); ++i) {
    const std::size_t unknown = unknown_of(space_, cell, i);
    result[i] = {quarter * gray.absorption, quarter * std::max(gray.emission[i], least_emission(cell)),
                 inertia[unknown] * space_.kelvin_per_value(unknown, temperature[unknown])};
  }
  return result;
}

double GrayDiffusion::floor_of(const GrayCell& cell) const {
  return least_absorption * cell.diffusion / (longest_path_ * longest_path_);
}

bool GrayDiffusion::has_jumps(const std::vector<GrayCell>& cells) const {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const CellIndex cell(static_cast<std::int32_t>(c));
    if (eliminates(space_, cell) && cells[c].absorption * std::cbrt(problem_.mesh().volume(cell)) > thick)
      return true;
  }
  return false;
}

NodalVector GrayDiffusion::light_of(const Eigen::VectorXd& solution, const std::vector<GrayCell>& cells,
                                    const std::vector<EliminatedCell>& eliminated,
                                    std::span<const double> gains) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  NodalVector light;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const std::int32_t vertex : mesh.vertices(CellIndex(static_cast<std::int32_t>(c))))
      light.push_back(solution[at(space_.unknowns_before_cells() + static_cast<std::size_t>(vertex))]);
  if (!has_jumps(cells)) return light;
  DiffusionCoefficients form;
  NodalVector right;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const CellIndex cell(static_cast<std::int32_t>(c));
    const double volume = mesh.volume(cell);
    double absorption = floor_of(cells[c]);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t unknown = space_.has(cell) ? unknown_of(space_, cell, i) : 0;
      if (eliminates(space_, cell)) {
        const EliminatedTemperature& own = eliminated[c][i];
        absorption += (1 - own.emitted_part()) * own.absorbing / volume;
        right.push_back(own.emitted_part() * gains[unknown]);
      } else {
        absorption += cells[c].absorption / 4;
        right.push_back(space_.has(cell) ? volume / 4 * cells[c].emission[i] * solution[at(unknown)] : 0);
      }
    }
    form.absorption.push_back(absorption);
    form.diffusion.push_back(cells[c].diffusion * Eigen::Matrix3d::Identity());
    form.lumped.push_back(1);
  }
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    form.reflectance.push_back(
        mean_reflectance(problem_, FaceIndex(f), cells[mesh.owner(FaceIndex(f)).at()].share));
  const VertexSpace vertices(mesh);
  const DiffusionSolver solver(mesh, vertices, form, accuracy_of_jumps, 1);
  NodalVector rest(light.size()), jumps(light.size());
  solver.matrix().residual(right, light, rest, 1);
  solver.approximate(rest, jumps);
  for (std::size_t i = 0; i < light.size(); ++i) light[i] += jumps[i];
  return light;
}

/// What absorbs in bands where it hardly emits is not heated at once [W/(m^3 K)].
double GrayDiffusion::least_emission(CellIndex cell) const {
  return least_slope * 4 * stefan_boltzmann * std::pow(space_.usual_temperature(), 3) *
         absorption_of_all_bands(problem_, cell);
}

}  // namespace etendue
