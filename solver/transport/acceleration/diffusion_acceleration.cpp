// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/acceleration/diffusion_acceleration.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "base/wall_clock.h"
#include "solver/problem/mirror.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

/// Extinctions that differ by more than this call for the non-local coefficient.
constexpr double large_contrast = 100;

/// Bounds of the free path that diffusion is given, the lower one in parts of that of a cell among black
/// ones, the upper one in mean chords of the domain, beyond which lengths mean nothing.
constexpr double shortest_part = 0.5;
constexpr double longest_chords = 100;

/// Of what passes a sheet, at least this part is taken to be lost on one passage.
constexpr double least_kept = 0.05;

/// How far the low-order solve goes. Beside sweeps with moments it costs next to nothing.
constexpr double accuracy_of_fluence = 0.5;
constexpr double accuracy_with_moments = 0.05;

/// Of isotropic light of fluence 1 through a plane, one way: 1/4; in the plane 1/pi.
double isotropic_partial_current(AngularSpace space) { return half_range(space) / full_range(space); }

double reflectance(const Wall& wall, std::size_t band) {
  return std::min(1.0,
                  wall.mean_reflectance(band) - wall.specular[band] + mirrored_part_of_isotropic(wall, band));
}

/// Mean length of the straight lines through a convex body.
double mean_chord(double volume, double area) { return 4 * volume / area; }

/// Constants spread light by themselves: through a face between them goes a quarter of the difference of
/// their fluences, as through a distance of 3/8 of the chord of a regular cell with D = 1. In free paths
/// thrice that.
constexpr double spread_of_constants = 3 * 0.375;

double mean_chord(const TetrahedralMesh& mesh, CellIndex cell) {
  double area = 0;
  for (const std::int32_t face : mesh.faces(cell)) area += mesh.area(FaceIndex(face));
  return mean_chord(mesh.volume(cell), area);
}

double mean_chord(const TetrahedralMesh& mesh) {
  double volume = 0, area = 0;
  for (const double part : mesh.volumes()) volume += part;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) area += mesh.area(FaceIndex(f));
  return mean_chord(volume, area);
}

}  // namespace

DiffusionAcceleration::DiffusionAcceleration(const Problem& problem, TransportSweep& sweep,
                                             std::span<const double> extinction, DiffusionLength length)
    : problem_(problem),
      sweep_(sweep),
      nodes_(static_cast<std::size_t>(sweep.cells().nodes())),
      vertices_(problem.mesh()),
      media_(diffusive_media(problem, sweep.directions(), sweep.discretization().scattering.plan,
                             sweep.discretization().scattering.groups)),
      extinction_(effective_extinction(problem, extinction, sweep.discretization().scattering.plan,
                                       sweep.discretization().scattering.groups)),
      caution_(static_cast<std::size_t>(problem.band_count()), 1),
      free_paths_(extinction_.size()),
      longest_free_path_(longest_chords * mean_chord(problem.mesh())) {
  // The state of a unit source is complex where radiances are, and says nothing about lengths.
  nonlocal_ = !sweep.cells().is_complex() && (length == DiffusionLength::nonlocal ||
                                              (length == DiffusionLength::automatic && wants_nonlocal()));
  std::unique_ptr<TransportState> path;
  if (nonlocal_) {
    path = std::make_unique<TransportState>(sweep.layout());
    sweep.apply_to_unit_source(*path);
    ++sweeps_;
    check_finite(sweep, sweeps_, *path);
  }
  for (std::size_t i = 0; i < media_.size(); ++i) {
    double& caution = caution_[i % caution_.size()];
    caution = std::max(caution, media_[i].slope.norm() / std::sqrt(3.0));
  }
  // Diffusion ends at sheets: of light that goes to and fro through one it knows the first passage alone.
  for (const Wall& wall : problem.walls())
    for (std::size_t band = 0; band < wall.transmittance.size(); ++band)
      caution_[band] = std::max(caution_[band], 1 / std::max(1 - wall.transmittance[band], least_kept));
  const auto start = WallClock::now();
  const double accuracy =
      sweep.discretization().moments.row_count() > 0 ? accuracy_with_moments : accuracy_of_fluence;
  std::vector<DiffusionCoefficients> known;
  for (std::size_t band = 0; band < static_cast<std::size_t>(problem.band_count()); ++band) {
    DiffusionCoefficients wanted = coefficients(band, path.get());
    const auto same = std::find(known.begin(), known.end(), wanted);
    solver_of_.push_back(static_cast<std::size_t>(same - known.begin()));
    if (same != known.end()) continue;
    try {
      solvers_.push_back(
          std::make_unique<DiffusionSolver>(problem.mesh(), vertices_, wanted, accuracy, sweep.threads()));
      faults_.emplace_back();
    } catch (const std::domain_error& fault) {
      solvers_.push_back(nullptr);
      faults_.emplace_back(fault.what());
    }
    known.push_back(std::move(wanted));
  }
  setup_seconds_ = seconds_since(start);
}

bool DiffusionAcceleration::wants_nonlocal() const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  for (std::size_t band = 0; band < bands; ++band) {
    double smallest = extinction_[band], largest = smallest;
    for (std::size_t at = band; at < extinction_.size(); at += bands) {
      smallest = std::min(smallest, extinction_[at]);
      largest = std::max(largest, extinction_[at]);
    }
    if (largest >= large_contrast * smallest) return true;
  }
  return false;
}

// The mean of the flight lengths to where light comes from, or 1/sigma_t. The elements of the one may be
// negative where extinctions jump, the other is infinite in a void. Nothing is shorter than in a cell among
// black ones, about 1/(sigma_t + 1/chord) (Wigner's rational approximation).
double DiffusionAcceleration::free_path(CellIndex cell, std::size_t band, const TransportState* path) const {
  const double extinction = extinction_[cell.at() * static_cast<std::size_t>(problem_.band_count()) + band];
  double result = 1 / extinction;
  if (path != nullptr) {
    result = 0;
    for (std::size_t i = 0; i < 4; ++i)
      result += path->fluence()[at_corner(cell.at(), i, band)] / (4 * full_range(problem_.space()));
  }
  const double chord = mean_chord(problem_.mesh(), cell);
  const double shortest = shortest_part / (extinction + 1 / chord);
  const double spread = nodes_ == 1 ? spread_of_constants * chord : 0;
  return std::min(longest_free_path_, std::max(shortest, result) + spread);
}

double DiffusionAcceleration::imaginary_extinction(std::size_t cell, std::size_t band) const {
  return sweep_.discretization().added.imaginary[(cell * solver_of_.size() + band) / 2];
}

double DiffusionAcceleration::added_absorption(std::size_t at) const {
  const AddedExtinction& added = sweep_.discretization().added;
  return added.real_at(at) + (added.is_complex() ? added.imaginary[at / 2] : 0);
}

DiffusionCoefficients DiffusionAcceleration::coefficients(std::size_t band, const TransportState* path) {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  DiffusionCoefficients result;
  result.partial_current = isotropic_partial_current(problem_.space());
  result.is_plane = problem_.space() == AngularSpace::plane;
  for (std::size_t c = 0; c < static_cast<std::size_t>(mesh.cell_count()); ++c) {
    const CellIndex cell(static_cast<std::int64_t>(c));
    // Not as extinction less scattering, in which a tiny absorption is lost.
    result.absorption.push_back(problem_.absorption()[c * bands + band] + added_absorption(c * bands + band));
    free_paths_[c * bands + band] = free_path(cell, band, path);
    result.diffusion.push_back(free_paths_[c * bands + band] * medium(cell, band).diffusion);
    result.lumped.push_back(sweep_.cells().is_lumped(cell, static_cast<int>(band)));
  }
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    result.reflectance.push_back(reflectance(problem_.wall(mesh.wall(FaceIndex(f))), band));
  return result;
}

void DiffusionAcceleration::apply(const TransportState& residual, TransportState& corrected,
                                  const std::vector<char>& active) {
  const auto start = WallClock::now();
  std::copy(residual.values().begin(), residual.values().end(), corrected.values().begin());
  const std::size_t step = sweep_.cells().is_complex() ? 2 : 1;
  for (std::size_t band = 0; band < solver_of_.size(); band += step) {
    if (!active[band] || !acts_on(band)) continue;
    if (step == 2)
      correct_pair(band, residual, corrected);
    else
      add_correction(band, approximate(band, right_side(band, residual)), residual, corrected);
  }
  seconds_ += seconds_since(start);
}

NodalVector DiffusionAcceleration::approximate(std::size_t band, const NodalVector& right) {
  NodalVector correction(right.size());
  solvers_[solver_of_[band]]->approximate(right, correction);
  return correction;
}

// (D7) of docs/theory/iteration.md. With K = Im s n / c and f + i g on the right-hand side, h = x + y of
// (A + K) h = f + g and (A + K) x = f + K h.
void DiffusionAcceleration::correct_pair(std::size_t band, const TransportState& residual,
                                         TransportState& corrected) {
  NodalVector right = right_side(band, residual), sum = right_side(band + 1, residual);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += right[i];
  const NodalVector both = approximate(band, sum);
  for (std::size_t c = 0; c < both.size() / 4; ++c) {
    const CellIndex cell(static_cast<std::int64_t>(c));
    nodes_of(std::span<double>(right), c) +=
        imaginary_extinction(c, band) *
        (mass_matrix(problem_.mesh().volume(cell), sweep_.cells().is_lumped(cell, static_cast<int>(band))) *
         nodes_of(std::span<const double>(both), c));
  }
  const NodalVector real = approximate(band, right);
  NodalVector imaginary = both;
  for (std::size_t i = 0; i < imaginary.size(); ++i) imaginary[i] -= real[i];
  add_correction(band, real, residual, corrected);
  add_correction(band + 1, imaginary, residual, corrected);
}

void DiffusionAcceleration::add_correction(std::size_t band, const NodalVector& correction,
                                           const TransportState& residual, TransportState& corrected) const {
  for (std::size_t i = 0; i < correction.size(); ++i)
    corrected.fluence()[at_corner(i / 4, i % 4, band)] += share_of_corner() * correction[i];
  correct_moments(band, correction, corrected);
  correct_radiance(band, correction, corrected);
  correct_walls(band, correction, residual, corrected);
}

const DiffusiveMedium& DiffusionAcceleration::medium(CellIndex cell, std::size_t band) const {
  return media_[static_cast<std::size_t>(problem_.mesh().region(cell)) *
                    static_cast<std::size_t>(problem_.band_count()) +
                band];
}

/// Diffuse light is (phi - slope . omega) / 4 pi.
Eigen::Vector3d DiffusionAcceleration::slope(CellIndex cell, std::size_t band,
                                             const NodalVector& correction) const {
  const double path = free_paths_[cell.at() * static_cast<std::size_t>(problem_.band_count()) + band];
  const Eigen::Vector3d gradient =
      barycentric_gradients(problem_.mesh(), cell) * nodes_of(std::span<const double>(correction), cell.at());
  return path * (medium(cell, band).slope * gradient);
}

// Moment 0 is the fluence; 1, 2, 3 are those of sqrt(dimension) x, y, z.
void DiffusionAcceleration::correct_moments(std::size_t band, const NodalVector& correction,
                                            TransportState& corrected) const {
  const ScatteringMoments& scattering = sweep_.discretization().moments;
  const auto stride = static_cast<std::size_t>(sweep_.cells().stride());
  const auto moments = static_cast<std::size_t>(scattering.moment_count());
  const int axes = dimension(problem_.space());
  for (std::size_t row = 0; row < scattering.row_count(); ++row) {
    const CellIndex cell(scattering.angular_cells()[row]);
    double* values = corrected.moments().data() + row * moments * nodes_ * stride + band;
    for (std::size_t i = 0; i < 4; ++i)
      values[i % nodes_ * stride] += share_of_corner() * correction[4 * cell.at() + i];
    if (moments == 1) continue;
    const Eigen::Vector3d first = -slope(cell, band, correction) / std::sqrt(axes);
    for (int axis = 0; axis < axes; ++axis)
      for (std::size_t i = 0; i < nodes_; ++i)
        values[(static_cast<std::size_t>(axis + 1) * nodes_ + i) * stride] += first[axis];
  }
}

// Where scattering is by a matrix it takes its light from the radiance.
void DiffusionAcceleration::correct_radiance(std::size_t band, const NodalVector& correction,
                                             TransportState& corrected) const {
  const DenseScattering& dense = sweep_.discretization().dense;
  const auto stride = static_cast<std::size_t>(sweep_.cells().stride());
  const double share = 1 / full_range(problem_.space());
  const std::size_t rows = dense.cells().size();
  std::vector<Eigen::Vector3d> slopes;
  for (const std::int32_t cell : dense.cells()) slopes.push_back(slope(CellIndex(cell), band, correction));
  for (std::int32_t m = 0; rows > 0 && m < sweep_.directions().count(); ++m)
    for (std::size_t row = 0; row < rows; ++row) {
      const auto cell = static_cast<std::size_t>(dense.cells()[row]);
      const double odd = slopes[row].dot(sweep_.directions().direction(OrdinateIndex(m)));
      double* radiance = corrected.radiance().data() +
                         (static_cast<std::size_t>(m) * rows + row) * dense.row_length() + band;
      for (std::size_t i = 0; i < 4; ++i)
        radiance[i % nodes_ * stride] += share_of_corner() * share * (correction[4 * cell + i] - odd);
    }
}

// What scatters of a residual in all directions, for a scattering coefficient of 1.
NodalVector DiffusionAcceleration::scattered(std::size_t band, const TransportState& residual) const {
  const auto stride = static_cast<std::size_t>(sweep_.cells().stride());
  NodalVector result(4 * static_cast<std::size_t>(problem_.mesh().cell_count()));
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = medium(CellIndex(static_cast<std::int64_t>(i / 4)), band).scattered *
                residual.fluence()[at_corner(i / 4, i % 4, band)];
  const DenseScattering& dense = sweep_.discretization().dense;
  const std::size_t rows = dense.cells().size();
  for (std::size_t row = 0; row < rows; ++row) {
    const auto cell = static_cast<std::size_t>(dense.cells()[row]);
    const std::vector<double>& factors = medium(CellIndex(dense.cells()[row]), band).scattered_of;
    for (std::size_t i = 0; i < 4 && !factors.empty(); ++i) result[4 * cell + i] = 0;
    for (std::size_t m = 0; m < factors.size(); ++m) {
      const double* radiance = residual.radiance().data() + (m * rows + row) * dense.row_length() + band;
      for (std::size_t i = 0; i < 4; ++i) result[4 * cell + i] += factors[m] * radiance[i % nodes_ * stride];
    }
  }
  return result;
}

double DiffusionAcceleration::reflectance_seen(FaceIndex face, std::size_t band) const {
  if (sweep_.walls().half_range()[face.at()] == 0) return 0;
  return reflectance(problem_.wall(problem_.mesh().wall(face)), band);
}

// Light that scatters for the first time, sigma_s r of (D2), and the part beta that walls reflect for the
// first time, (D3) and (D4) of docs/theory/iteration.md: with the partial currents J of diffusion J_in =
// alpha J_out + beta r_E, so -D dn phi = 2 a (1-alpha)/(1+alpha) phi
// - 2 beta/(1+alpha) r_E (docs/theory/iteration.md, D4).
NodalVector DiffusionAcceleration::right_side(std::size_t band, const TransportState& residual) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto stride = static_cast<std::size_t>(sweep_.cells().stride());
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  const NodalVector source = scattered(band, residual);
  NodalVector right(4 * cells, 0);
  for (std::size_t c = 0; c < cells; ++c) {
    const CellIndex cell(static_cast<std::int64_t>(c));
    nodes_of(std::span<double>(right), c) =
        problem_.scattering()[c * bands + band] *
        (mass_matrix(mesh.volume(cell), sweep_.cells().is_lumped(cell, static_cast<int>(band))) *
         nodes_of(std::span<const double>(source), c));
  }
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const double alpha = reflectance_seen(face, band);
    if (alpha == 0) continue;
    const CellIndex cell = mesh.owner(face);
    const double factor = 2 * sweep_.walls().fed_back(face, band) / (1 + alpha) * mesh.area(face) / 12;
    const std::size_t values = nodes_ == 1 ? 1 : 3;
    const double* arriving = residual.irradiance().data() + face.at() * values * stride + band;
    const auto at = [&](std::size_t corner) { return arriving[corner % values * stride]; };
    std::size_t corner = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (mesh.faces(cell)[i] != f)
        right[4 * cell.at() + i] += factor * (at(0) + at(1) + at(2) + at(corner++));
  }
  return right;
}

// The partial current that leaves, J_out = (2 a phi - beta r_E) / (1+alpha).
void DiffusionAcceleration::correct_walls(std::size_t band, const NodalVector& correction,
                                          const TransportState& residual, TransportState& corrected) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const double twice = 2 * isotropic_partial_current(problem_.space());
  const auto stride = static_cast<std::size_t>(sweep_.cells().stride());
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const double alpha = reflectance_seen(face, band);
    if (alpha == 0) continue;
    const CellIndex cell = mesh.owner(face);
    const double returned = sweep_.walls().fed_back(face, band);
    const std::size_t values = nodes_ == 1 ? 1 : 3;
    std::size_t corner = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (mesh.faces(cell)[i] == f) continue;
      const std::size_t at = (face.at() * values + corner++ % values) * stride + band;
      const double current =
          (twice * correction[4 * cell.at() + i] - returned * residual.irradiance()[at]) / (1 + alpha);
      corrected.irradiance()[at] += nodes_ == 1 ? current / 3 : current;
    }
    sweep_.walls().add_leaving(face, band, residual.irradiance(), corrected.irradiance(),
                               corrected.mirrors());
  }
}

std::vector<std::string> DiffusionAcceleration::notes() const {
  std::vector<std::string> notes;
  for (std::size_t band = 0; band < solver_of_.size(); ++band)
    if (!acts_on(band))
      notes.push_back(fmt::format("not accelerated in band {}: {}", problem_.bands().names[band],
                                  faults_[solver_of_[band]]));
  if (notes.size() == solver_of_.size()) return notes;
  int cycles = 0;
  for (const auto& solver : solvers_) cycles = std::max(cycles, solver ? solver->steps() : 0);
  notes.insert(
      notes.begin(),
      fmt::format("accelerated by diffusion: {}, {} of two levels for each sweep",
                  nonlocal_
                      ? "non-local coefficient (a void, or extinctions that differ by more than 100 times)"
                      : "local coefficient",
                  cycles == 1 ? "one cycle" : fmt::format("{} cycles", cycles)));
  return notes;
}

}  // namespace etendue
