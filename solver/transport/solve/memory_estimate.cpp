// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/parallel/thread_count.h"
#include "solver/angular/harmonics/spherical_harmonics.h"
#include "solver/angular/kernels/kernel_places.h"
#include "solver/problem/mirror.h"
#include "solver/transport/iteration/gmres.h"
#include "solver/transport/iteration/positive_iteration.h"
#include "solver/transport/order/batch_sections.h"
#include "solver/transport/scattering/scattering_plan.h"
#include "solver/transport/solve/acceleration_policy.h"
#include "solver/transport/solve/angular_multigrid.h"
#include "solver/transport/solve/precision_policy.h"
#include "solver/transport/solve/solve.h"
#include "solver/transport/source/directional_emission.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {
namespace {

/// Vectors of a cycle in runs that diffusion or fewer directions accelerate: runs of cases/ take 4 to 20
/// sweeps, in single precision in two cycles or more.
constexpr double typical_krylov_basis = 20;
constexpr double typical_krylov_basis_in_single_precision = 12;

/// Numbers of things, as doubles: products of them overflow integers exactly where the answer matters.
struct Sizes {
  double cells = 0;
  double faces = 0;  ///< on the boundary
  double ordinates = 0;
  double cell_length = 0;    ///< doubles
  double trace_length = 0;   ///< doubles
  double record_length = 0;  ///< doubles
  double stride = 0;
  double angular_cells = 0;
  double dense_cells = 0;
  double absorptions = 0;  ///< of cells and bands that depend on the direction
  double matrices = 0;
  double moments = 1;
  double mirrors = 0;          ///< faces whose light the next sweep reflects
  double passing_mirrors = 0;  ///< faces whose light the same sweep reflects
  bool iterates = false;       ///< whether light comes back to where it was, but for orders with cycles
  GlossyWalls::Size glossy;
};

bool scatters(const Problem& problem, CellIndex cell) {
  for (int band = 0; band < problem.band_count(); ++band)
    if (problem.scattering(cell, band) > 0) return true;
  return false;
}

/// One, or where the kernel differs from cell to cell one for each place, which all bands share.
double matrices_of(const Problem& problem, std::size_t of_plan) {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const auto region = static_cast<int>(of_plan / bands);
  const auto places = kernel_places(problem, region, static_cast<int>(of_plan % bands)).size();
  if (places == 0) return 1;
  return of_plan % bands == 0 ? static_cast<double>(places) : 0;
}

/// Whether the next sweep reflects or transmits light of a wall, beside that of a mirror.
bool reflects_diffusely(const Wall& wall) {
  for (std::size_t band = 0; band < wall.diffuse.size(); ++band)
    if (wall.mean_reflectance(band) - wall.specular[band] + wall.transmitted(band) > 0) return true;
  return false;
}

void count_mirrors(const Problem& problem, const DirectionSet& directions, Sizes& sizes) {
  const TetrahedralMesh& mesh = problem.mesh();
  const OrdinateSchedule schedule(problem, directions, Batches::of_neighbours);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const Vec3 normal = mesh.area_normal(face).normalized();
    const Wall& wall = problem.wall(mesh.wall(face));
    if (directions.half_range(normal) <= out_of_reach) continue;
    sizes.iterates = sizes.iterates || reflects_diffusely(wall);
    if (is_mirror(wall)) (schedule.knows_reflections(normal) ? sizes.passing_mirrors : sizes.mirrors) += 1;
  }
}

Sizes sizes_of(const Problem& problem, const DirectionSet& directions, const SolveOptions& options) {
  const TetrahedralMesh& mesh = problem.mesh();
  const Basis basis = options.order == SpaceOrder::linear ? Basis::linear : Basis::constant;
  Sizes sizes;
  sizes.cells = mesh.cell_count();
  sizes.faces = mesh.boundary_face_count();
  sizes.ordinates = directions.count();
  sizes.stride = lane_stride(problem.band_count());
  sizes.cell_length = nodes_per_cell(basis) * sizes.stride;
  sizes.trace_length = nodes_per_face(basis) * sizes.stride;
  sizes.record_length = static_cast<double>(record_layout(basis, lane_stride(problem.band_count())).length);
  const std::vector<ScatteringTreatment> plan = plan_scattering(problem, directions);
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<int> degrees(problem.media().size(), 0);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    degrees[i / bands] = std::max(degrees[i / bands], plan[i].degree);
    if (plan[i].is_dense()) sizes.matrices += matrices_of(problem, i);
  }
  sizes.dense_cells = static_cast<double>(dense_cells(problem, plan).size());
  sizes.angular_cells = sizes.dense_cells;
  int highest = 0;
  const AngularInput* input = options.angular_input;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const int degree = degrees[static_cast<std::size_t>(mesh.region(CellIndex(c)))];
    const bool scatters_so = degree > 0 && scatters(problem, CellIndex(c));
    const bool emits_so = DirectionalEmission::emits(problem.medium(mesh.region(CellIndex(c))));
    for (int band = 0; band < problem.band_count(); ++band)
      if (problem.medium(mesh.region(CellIndex(c))).absorbs_by_direction(band)) sizes.absorptions += 1;
    if (scatters_so || emits_so || (input != nullptr && input->depends_on_direction(CellIndex(c))))
      sizes.angular_cells += 1;
    if (scatters_so) highest = std::max(highest, degree);
  }
  sizes.angular_cells = std::min(sizes.angular_cells, sizes.cells);
  sizes.moments = harmonic_count(directions.space(), highest);
  count_mirrors(problem, directions, sizes);
  sizes.glossy = GlossyWalls::size_of(problem, directions);
  sizes.iterates = sizes.iterates || sizes.mirrors > 0 ||
                   std::ranges::any_of(problem.scattering(), [](double s) { return s > 0; });
  return sizes;
}

/// Numbers of a state.
double state_length(const Sizes& s) {
  const double of_cells = s.cells + s.angular_cells * s.moments + s.dense_cells * s.ordinates;
  return of_cells * s.cell_length +
         (s.faces + (s.mirrors + s.glossy.faces) * s.ordinates / 2) * s.trace_length;
}

double longest_cycle_of(double state) {
  return std::clamp(static_cast<double>(krylov_memory) / (8 * state),
                    static_cast<double>(shortest_krylov_basis),
                    static_cast<double>(longest_krylov_basis) + 1);
}

/// Light that goes to and fro between mirrors and is scattered by a matrix is accelerated least: 60 to 100
/// sweeps in cases/.
double typical_basis(const Sizes& s, bool is_mixed) {
  if (s.mirrors > 0 && s.dense_cells > 0) return longest_krylov_basis;
  return is_mixed ? typical_krylov_basis_in_single_precision : typical_krylov_basis;
}

}  // namespace

double longest_cycle(const Problem& problem, const DirectionSet& directions, const SolveOptions& options) {
  return longest_cycle_of(state_length(sizes_of(problem, directions, options)));
}

std::size_t estimate_memory(const Problem& problem, const DirectionSet& directions,
                            const SolveOptions& options, KrylovVectors vectors) {
  const Sizes s = sizes_of(problem, directions, options);
  const double fields = s.cells * s.cell_length;
  const double moments = s.angular_cells * s.moments * s.cell_length;
  const double radiance = s.dense_cells * s.ordinates * s.cell_length;
  const double state = state_length(s);
  // Two changes for each step of the past, the image, its residual and their last ones, the best state.
  const double positive =
      options.positivity == Positivity::none ? 0 : 2.0 * static_cast<double>(anderson_memory(state)) + 7;
  // Source iteration: what is corrected, those bands that are left, and F(0).
  const bool is_typical = vectors == KrylovVectors::typical, iterates = s.iterates;
  double basis = options.method == Method::source_iteration ? 3 : longest_cycle_of(state);
  const bool is_mixed = (!is_typical || iterates) && has_cycles_in_single_precision(problem, options);
  if (is_typical) basis = iterates ? std::min(basis, typical_basis(s, is_mixed)) : 0;
  const int threads = thread_count(options.threads);
  // Cells at the boundary keep their slots; besides, a front through the mesh is live at a time.
  const double slots = (2 * s.faces + 8 * std::pow(s.cells, 2.0 / 3)) * s.cell_length;
  const OrdinateSchedule schedule(problem, directions, Batches::of_neighbours);
  const double batch = schedule.batch();
  // Sums of sections of batches that wait for others, of moments one less, and one that grows.
  const double waiting = std::log2(BatchSections(schedule.batch_count()).count());
  const double section_sums =
      waiting * (fields + s.faces * s.trace_length) + std::max(1.0, waiting) * moments;
  // The numbers that sweeps in a precision work on: fluence, and in those that are recorded net flux.
  const auto workspaces_of = [&](std::size_t bytes, double summed_fields) {
    const bool is_tiled = static_cast<double>(bytes) * s.cells * (s.record_length + s.cell_length) >
                          static_cast<double>(options.cache_bytes);
    return std::min<double>(threads, std::ceil(s.ordinates / batch)) *
           ((is_tiled ? largest_group : 1) * slots + summed_fields * fields + 2 * s.faces * s.trace_length +
            batch * s.angular_cells * s.cell_length);
  };
  const double workspaces = workspaces_of(sizeof(double), 4);
  const double records =
      s.cells * static_cast<double>(s.record_length) * (s.dense_cells > 0 ? 1 + threads : 1) +
      2 * s.matrices * s.ordinates * s.ordinates + DirectionalEmission::table_size(problem, directions) +
      s.absorptions * s.ordinates + s.glossy.matrices +
      (s.glossy.faces + s.passing_mirrors) * s.ordinates / 2 * s.trace_length;
  // The record of the last sweep, and the solution: fluence, three components of flux, the state.
  const double results = 3 * fields + 16 * s.cells * s.stride + state;
  const double kept = static_cast<double>(options.keep_ordinates.size()) * 2 * fields;
  // Five blocks of 16 and an inverse for each cell and band, the levels on vertices and a few vectors.
  // They judge even where they do not accelerate.
  const bool has_low_order = !is_typical || (iterates && plan_low_order(problem, options).is_needed);
  const double low_order = has_low_order ? s.cells * problem.band_count() * 150 : 0;
  // A sweep of fewer bands, once others are done: half the lanes at most, and two states.
  const bool has_fewer_bands = problem.band_count() > 1 && (!is_typical || iterates);
  const double of_active_bands = has_fewer_bands && !(is_typical && is_mixed)
                                     ? (workspaces + records + moments + radiance) / 2 + state
                                     : 0;
  // The same sweep in single precision.
  const double of_floats = workspaces_of(sizeof(float), 1) + records + moments + radiance;
  const double single = is_mixed ? of_floats / 2 + (has_fewer_bands ? of_floats / 4 + state : 0) : 0;
  // The sweep of fewer directions, in single precision too, and its states.
  const bool is_corrected =
      (!is_typical || iterates) && coarser_directions(problem, directions, options).has_value();
  const double coarse =
      is_corrected ? (workspaces_of(sizeof(float), 1) + records + moments) / 2 + 2 * state : 0;
  const auto orders_of = [&](double ordinates) {
    return std::min(static_cast<double>(options.order_memory), ordinates / 2 * s.cells * sizeof(SweepVisit));
  };
  const double orders = orders_of(s.ordinates) + (is_corrected ? orders_of(coarsest_directions) : 0);
  // Sources of moments and matrices too.
  const double always = 2 * state + section_sums + workspaces + records + moments + radiance + low_order;
  // The iteration has a place to correct in beside its vectors; at most, others hold the states of the first
  // and the best iterate and of what is saved and read out.
  const double corrected = (!is_typical ? 5 : iterates ? 1 : 0) * state;
  const double iteration = std::max(basis, positive) * state + corrected + of_active_bands + single + coarse;
  // The vectors of the iteration are given back before the solution is read out.
  const double besides = is_typical ? std::max(iteration, results + kept) : iteration + results + kept;
  return static_cast<std::size_t>(8 * (always + besides) + orders);
}

}  // namespace etendue
