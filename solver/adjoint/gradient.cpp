// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/adjoint/gradient.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "base/errors.h"
#include "base/field_view.h"
#include "base/parallel/parallel_for.h"
#include "base/parallel/thread_count.h"
#include "base/vector_sums.h"
#include "solver/adjoint/response_source.h"
#include "solver/adjoint/reversed_problem.h"
#include "solver/transport/scattering/scattering_plan.h"
#include "solver/transport/source/directional_emission.h"
#include "solver/transport/source/ordinate_lights.h"
#include "solver/transport/state/state_copy.h"
#include "solver/transport/sweep/transport_sweep.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {
namespace {

void refuse_rays(const Problem& problem) {
  const LightSetup lights(problem);
  if (!lights.empty())
    throw InputError("a gradient needs all light on the directions; use uncollided = false for the light " +
                     lights.sources().front()->name());
}

/// Integral over a cell of the product of two functions with the mass of the sweep's equations. `u` and `v`
/// are [node][stride].
double product(const CellCoefficients& cells, double volume, CellIndex cell, int band, const double* u,
               const double* v) {
  if (cells.nodes() == 1) return volume * u[band] * v[band];
  const int stride = cells.stride();
  double all_u = 0, all_v = 0, own = 0;
  for (int i = 0; i < 4; ++i) {
    all_u += u[i * stride + band];
    all_v += v[i * stride + band];
    own += u[i * stride + band] * v[i * stride + band];
  }
  return cells.is_lumped(cell, band) ? volume / 4 * own : volume / 20 * (all_u * all_v + own);
}

/// The sweep of a problem at its solution.
class ConvergedSweep {
 public:
  /// The arguments must outlive it.
  ConvergedSweep(const Problem& problem, const DirectionSet& directions, const SolveOptions& options,
                 const Solution& solution)
      : extinction_(problem.absorption().begin(), problem.absorption().end()),
        sweep_(problem, directions, with_scattering(problem), options),
        state_(sweep_.layout()) {
    SavedState saved = solution.state;
    saved.moments = moments_of(solution);
    restore(saved, problem.band_count(), state_);
    TransportState next(sweep_.layout());
    sweep_.apply(state_, next);  // mirrors within the sweep
  }

  std::vector<OrdinateRadiance> radiance_along(std::span<const int> ordinates) {
    return sweep_.radiance_along(state_, ordinates);
  }
  const CellCoefficients& cells() const { return sweep_.cells(); }
  const ScatteringMoments& moments() const { return sweep_.discretization().moments; }
  double forward(int region, int band) const {
    const auto bands = static_cast<std::size_t>(cells().bands());
    const auto at = static_cast<std::size_t>(region) * bands + static_cast<std::size_t>(band);
    return sweep_.discretization().scattering.plan[at].forward;
  }
  /// [node][stride] of a moment; of cells that are not angular the first alone.
  const double* moment(CellIndex cell, int k) const {
    const auto row = static_cast<std::size_t>(row_of(cell));
    if (row == 0) return state_.fluence().data() + cell.at() * cells().cell_length();
    const auto count = static_cast<std::size_t>(moments().moment_count());
    return state_.moments().data() +
           ((row - 1) * count + static_cast<std::size_t>(k)) * cells().cell_length();
  }
  int row_of(CellIndex cell) const { return moments().index() == nullptr ? 0 : moments().row(cell); }

 private:
  /// Moments of a solution [angular cell][moment][node][band] for the angular cells of this sweep. Cells that
  /// the solution kept none for scatter alike in all directions, and their fluence says all.
  std::vector<double> moments_of(const Solution& solution) const {
    const auto cell_values = static_cast<std::size_t>(cells().nodes() * cells().bands());
    const std::size_t row = static_cast<std::size_t>(moments().moment_count()) * cell_values;
    std::vector<double> values(moments().row_count() * row, 0);
    for (std::size_t r = 0; r < moments().row_count(); ++r) {
      const std::int32_t cell = moments().angular_cells()[r];
      const auto found = std::ranges::lower_bound(solution.angular_cells, cell);
      const bool kept = found != solution.angular_cells.end() && *found == cell;
      const auto from = kept ? solution.state.moments.begin() +
                                   (found - solution.angular_cells.begin()) * static_cast<std::ptrdiff_t>(row)
                             : solution.state.fluence.begin() +
                                   static_cast<std::ptrdiff_t>(static_cast<std::size_t>(cell) * cell_values);
      std::copy_n(from, kept ? row : cell_values, values.begin() + static_cast<std::ptrdiff_t>(r * row));
    }
    return values;
  }

  std::span<const double> with_scattering(const Problem& problem) {
    add_to(extinction_, problem.scattering());
    return extinction_;
  }

  std::vector<double> extinction_;  ///< [cell][band]
  TransportSweep sweep_;
  TransportState state_;
};

/// [cell][band] sum over m of w_m times the integral of u_m u+_m.
std::vector<double> angular_products(ConvergedSweep& forward, ConvergedSweep& reversed,
                                     const TetrahedralMesh& mesh, const DirectionSet& directions,
                                     int threads) {
  const CellCoefficients& cells = forward.cells();
  const auto bands = static_cast<std::size_t>(cells.bands());
  std::vector<double> products(mesh.volumes().size() * bands, 0);
  const std::size_t one = 2 * mesh.volumes().size() * cells.cell_length() * sizeof(double);
  const int at_once = static_cast<int>(std::max<std::size_t>(1, gradient_bytes / one));
  for (int first = 0; first < directions.count(); first += at_once) {
    std::vector<int> along(static_cast<std::size_t>(std::min(at_once, directions.count() - first)));
    std::iota(along.begin(), along.end(), first);
    const auto u = forward.radiance_along(along);
    for (int& ordinate : along) ordinate ^= 1;
    const auto v = reversed.radiance_along(along);
    parallel_for(mesh.volumes().size(), threads, 256, [&](std::size_t c) {
      for (std::size_t m = 0; m < u.size(); ++m)
        for (std::size_t b = 0; b < bands; ++b)
          products[c * bands + b] +=
              directions.weight(OrdinateIndex(u[m].ordinate)) *
              product(cells, mesh.volumes()[c], CellIndex(static_cast<std::int64_t>(c)), static_cast<int>(b),
                      u[m].values.data() + c * cells.cell_length(),
                      v[m].values.data() + c * cells.cell_length());
      return true;
    });
  }
  return products;
}

/// What scatters in a cell by a coefficient of 1, times the importance.
double scattering_product(const ConvergedSweep& forward, const ConvergedSweep& reversed,
                          const Problem& problem, CellIndex cell, int band) {
  const int region = problem.mesh().region(cell);
  const int count =
      forward.row_of(cell) > 0 && reversed.row_of(cell) > 0 ? forward.moments().moment_count() : 1;
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    const double sign = forward.moments().degree_of(k) % 2 == 0 ? 1 : -1;  // against the directions
    sum += sign * forward.moments().phase_moment(region, k, band) *
           product(forward.cells(), problem.mesh().volume(cell), cell, band, forward.moment(cell, k),
                   reversed.moment(cell, k));
  }
  return sum / full_range(problem.space());
}

/// Adds to a gradient what the walls say.
void add_walls(const Problem& problem, const Solution& solution, const Solution& importance,
               Gradient& gradient) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const ConstFaceField u(solution.irradiance, bands), v(importance.irradiance, bands);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const bool refracts = problem.wall(mesh.wall(face)).refractive_index != 1;
    const double half_range = solution.half_range[face.at()];
    for (std::size_t b = 0; b < bands; ++b) {
      gradient.radiance.push_back(refracts ? std::numeric_limits<double>::quiet_NaN()
                                           : mesh.area(face) * v.mean(face, b));
      double own = 0;
      for (std::size_t i = 0; i < 3; ++i) own += u(face, i, b) * v(face, i, b);
      gradient.diffuse.push_back(mesh.area(face) / 12 * (9 * u.mean(face, b) * v.mean(face, b) + own) /
                                 half_range);
    }
  }
}

}  // namespace

Gradient gradient_of(const Problem& problem, const DirectionSet& directions, const Response& response,
                     const SolveOptions& wanted, const Solution& solution, const Solution& importance) {
  refuse_rays(problem);
  check_gradient(problem, directions);
  SolveOptions options = wanted;
  options.meters.clear();
  options.keep_ordinates.clear();
  const OrdinateLights lights(problem, directions, nullptr);
  const DirectionalEmission emission(problem, directions, lights.empty() ? nullptr : &lights);
  if (!lights.empty()) options.angular_input = &lights;
  if (!emission.empty()) options.angular_input = &emission;
  ConvergedSweep forward(problem, directions, options, solution);
  const Problem reversed = reversed_problem(problem, wanted);
  const ResponseSource source(reversed, directions, response);
  options.angular_input = &source;
  ConvergedSweep backward(reversed, directions, options, importance);
  Gradient gradient;
  gradient.absorption =
      angular_products(forward, backward, problem.mesh(), directions, thread_count(wanted.threads));
  gradient.scattering = gradient.absorption;
  const auto* absorbed = std::get_if<AbsorbedPower>(&response);
  const auto bands = static_cast<std::size_t>(problem.band_count());
  for (std::size_t i = 0; i < gradient.absorption.size(); ++i) {
    const CellIndex cell(static_cast<std::int64_t>(i / bands));
    const int band = static_cast<int>(i % bands);
    const int region = problem.mesh().region(cell);
    const double volume = problem.mesh().volume(cell);
    gradient.scattering[i] = scattering_product(forward, backward, problem, cell, band) -
                             (1 - forward.forward(region, band)) * gradient.absorption[i];
    gradient.absorption[i] = -gradient.absorption[i];
    gradient.emission.push_back(volume * ConstCellField(importance.fluence, bands).mean(cell, i % bands));
    if (absorbed != nullptr && absorbed->region == region)
      gradient.absorption[i] += volume * ConstCellField(solution.fluence, bands).mean(cell, i % bands);
  }
  add_walls(problem, solution, importance, gradient);
  return gradient;
}

void check_gradient(const Problem& problem, const DirectionSet& directions) {
  const std::vector<ScatteringTreatment> plan = plan_scattering(problem, directions);
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<Fault> faults;
  for (std::size_t r = 0; r < problem.media().size(); ++r) {
    const auto of_region = std::span(plan).subspan(r * bands, bands);
    if (std::ranges::any_of(of_region, &ScatteringTreatment::is_dense))
      faults.push_back(fault_at(problem.media()[r].origin, "",
                                "a gradient in media that scatter by a matrix is not in this version; use "
                                "scattering_method = \"moments\""));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

Problem on_directions(const Problem& problem) {
  std::vector<Medium> media(problem.media().begin(), problem.media().end());
  for (Medium& medium : media) medium.uncollided = Uncollided::no;
  std::vector<Wall> walls(problem.walls().begin(), problem.walls().end());
  for (Wall& wall : walls) wall.uncollided = Uncollided::no;
  std::vector<Light> lights(problem.lights().begin(), problem.lights().end());
  for (Light& light : lights) light.uncollided = Uncollided::no;
  return Problem(problem.mesh(), problem.bands(), std::move(media), std::move(walls), problem.space(),
                 std::move(lights));
}

}  // namespace etendue
