// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/cell_count.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "base/child_process.h"
#include "base/gibibyte.h"
#include "base/position.h"
#include "mesh/tetrahedra/mesh_faults.h"

namespace etendue {
namespace {

/// Largest cell over the mean one, as TetGen makes them under a bound.
constexpr double kBoundInMeans = 2.5;
/// Cells of a point, in a mesh of many.
constexpr double kCellsPerPoint = 6;
/// Cells around details beside those that the bounds ask for: TetGen makes them in about ten seconds.
constexpr double kDetailCells = 1e6;
constexpr double kDetailCellsPerPoint = 100;
/// From so many cells on it pays to mesh coarsely first.
constexpr double kManyCells = 1e6;
/// Memory of TetGen for a cell, and of the mesh that is read back [bytes].
constexpr double kBytesPerCell = 400;

Eigen::AlignedBox3d extent_of(const SurfaceComplex& surface) {
  Eigen::AlignedBox3d extent;
  for (const Vec3& point : surface.points) extent.extend(point);
  return extent;
}

Vec3 point_of(const TetGenMesh& mesh, std::int32_t point) {
  const double* x = &mesh.coordinates[3 * position(point)];
  return {x[0], x[1], x[2]};
}

/// Volumes of the cells over the bounds of their regions.
double volume_in_bounds(const TetGenMesh& mesh, const std::vector<double>& bounds) {
  double sum = 0;
  for (std::size_t c = 0; c < mesh.regions.size(); ++c) {
    const auto region = position(mesh.regions[c]);
    if (mesh.regions[c] < 0 || region >= bounds.size() || !(bounds[region] > 0)) continue;
    const Vec3 a = point_of(mesh, mesh.cells[4 * c]);
    const Vec3 ab = point_of(mesh, mesh.cells[4 * c + 1]) - a, ac = point_of(mesh, mesh.cells[4 * c + 2]) - a,
               ad = point_of(mesh, mesh.cells[4 * c + 3]) - a;
    sum += std::abs(ab.cross(ac).dot(ad)) / 6 / bounds[region];
  }
  return sum;
}

struct Edge {
  double length;
  Vec3 middle;
};

Edge shortest_edge(const TetGenMesh& mesh) {
  Edge shortest{std::numeric_limits<double>::infinity(), Vec3::Zero()};
  for (std::size_t c = 0; c + 3 < mesh.cells.size(); c += 4)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const Vec3 p = point_of(mesh, mesh.cells[c + i]), q = point_of(mesh, mesh.cells[c + j]);
        if (const double length = (p - q).norm(); length < shortest.length)
          shortest = {length, 0.5 * (p + q)};
      }
  return shortest;
}

}  // namespace

double asked_cells(const SurfaceComplex& surface, const TetrahedraOptions& options) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const double bound : options.max_volume)
    if (bound > 0) smallest = std::min(smallest, bound);
  const double at_most = kBoundInMeans * extent_of(surface).volume() / smallest;
  if (at_most <= kManyCells && (options.max_cells <= 0 || at_most <= options.max_cells)) return at_most;
  const TetGenOutcome coarse = call_tetgen(surface, {}, "pzA", most_added_points(surface, options, 0), {});
  // Where TetGen fails, it will fail again and say why.
  if (coarse.end != TetGenEnd::done) return 0;
  return kBoundInMeans * volume_in_bounds(coarse.mesh, options.max_volume);
}

void check_cell_count(double cells, const TetrahedraOptions& options) {
  if (options.max_cells > 0 && cells > options.max_cells)
    throw TooManyCells(fault_at(
        options.origin, "",
        fmt::format(
            "max_volume or edge_length asks for about {:.2g} cells, and max_cells allows {}; make one "
            "of them larger",
            cells, options.max_cells)));
  const double needed = kBytesPerCell * cells, installed = static_cast<double>(physical_memory());
  if (needed > installed)
    throw TooManyCells(fault_at(
        options.origin, "",
        fmt::format("max_volume or edge_length asks for about {:.2g} cells, for which TetGen needs about "
                    "{:.3g} GiB of memory, and this machine has {:.3g} GiB; use a larger one",
                    cells, needed / gibibyte, installed / gibibyte)));
}

int most_added_points(const SurfaceComplex& surface, const TetrahedraOptions& options, double asked_cells) {
  const double details = kDetailCells + kDetailCellsPerPoint * static_cast<double>(surface.points.size());
  // Meshes of few cells have more points for them; check_details() counts the cells.
  const double points =
      options.max_cells > 0 ? options.max_cells / 2.0 : (2 * asked_cells + details) / kCellsPerPoint;
  return static_cast<int>(std::clamp(points, 1.0, static_cast<double>(std::numeric_limits<int>::max())));
}

void refuse_details(const TetGenMesh& mesh, const SurfaceComplex& surface, const TetrahedraOptions& options,
                    int most_added) {
  const Edge finest = shortest_edge(mesh);
  throw TooManyCells(fault_at(
      options.origin, "",
      fmt::format("the geometry has details so fine that it needs more than {} cells (edges near {} "
                  "are {:.2g} long, and the geometry is {:.3g}); widen the gap or the part there, make "
                  "coordinates equal, or allow more by max_cells",
                  options.max_cells > 0 ? fmt::to_string(options.max_cells)
                                        : fmt::format("about {:.2g}", kCellsPerPoint * most_added),
                  to_text(finest.middle), finest.length, extent_of(surface).diagonal().norm())));
}

void check_details(const TetGenMesh& mesh, const SurfaceComplex& surface, const TetrahedraOptions& options,
                   int most_added) {
  const std::size_t cells = mesh.cells.size() / 4;
  if (options.max_cells > 0 && cells > static_cast<std::size_t>(options.max_cells))
    refuse_details(mesh, surface, options, most_added);
}

}  // namespace etendue
