// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/tetgen_call.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>

#define TETLIBRARY
#include <tetgen.h>

#include "base/array_bytes.h"
#include "base/child_process.h"
#include "mesh/tetrahedra/generation/tetgen_termination.h"

namespace etendue {
namespace {

constexpr int kOutOfMemory = 65;  // exit code of the child, beside those of TetGen and of the system
// Four times what it takes on a machine of two slow cores where points are dear, between facets that nearly
// meet.
constexpr double kLeastSeconds = 20;
constexpr double kSecondsPerPoint = 3e-4;
constexpr std::string_view kPointLimitWords = "desired number of Steiner points";
constexpr double kNoVolumeBound = -1;  // of a region in TetGen

// TetGen's structures own arrays made by new[]; the destructor of tetgenio deletes them.

double* copied(const std::vector<Vec3>& points) {
  auto* coordinates = new double[3 * points.size()];
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t axis = 0; axis < 3; ++axis)
      coordinates[3 * p + axis] = points[p][static_cast<Eigen::Index>(axis)];
  return coordinates;
}

void set_facet(tetgenio::facet& to, const SurfaceFacet& from) {
  tetgenio::init(&to);
  to.numberofpolygons = static_cast<int>(from.polygons.size());
  to.polygonlist = new tetgenio::polygon[from.polygons.size()];
  for (std::size_t i = 0; i < from.polygons.size(); ++i) {
    tetgenio::polygon& polygon = to.polygonlist[i];
    tetgenio::init(&polygon);
    polygon.numberofvertices = static_cast<int>(from.polygons[i].size());
    polygon.vertexlist = new int[from.polygons[i].size()];
    std::copy(from.polygons[i].begin(), from.polygons[i].end(), polygon.vertexlist);
  }
  to.numberofholes = static_cast<int>(from.openings.size());
  if (!from.openings.empty()) to.holelist = copied(from.openings);
}

/// Markers: wall + 1, then the sheets, then one more for interfaces. TetGen keeps the edge between facets
/// that differ in it.
int marker_of(const SurfaceFacet& facet, const SurfaceComplex& surface) {
  const int walls = static_cast<int>(surface.wall_names.size());
  if (facet.sheet >= 0) return walls + facet.sheet + 1;
  return facet.wall >= 0 ? facet.wall + 1 : walls + static_cast<int>(surface.sheets.size()) + 1;
}

void set_facets(tetgenio& in, const SurfaceComplex& surface) {
  in.numberoffacets = static_cast<int>(surface.facets.size());
  in.facetlist = new tetgenio::facet[surface.facets.size()];
  in.facetmarkerlist = new int[surface.facets.size()];
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    set_facet(in.facetlist[f], surface.facets[f]);
    in.facetmarkerlist[f] = marker_of(surface.facets[f], surface);
  }
}

/// Attributes: region + 1, so that 0 is what no seed has reached.
void set_regions(tetgenio& in, const SurfaceComplex& surface, const std::vector<double>& max_volume) {
  in.numberofregions = static_cast<int>(surface.seeds.size());
  in.regionlist = new double[5 * surface.seeds.size()];
  double* value = in.regionlist;
  for (const RegionSeed& seed : surface.seeds) {
    const auto region = static_cast<std::size_t>(seed.region);
    for (int axis = 0; axis < 3; ++axis) *value++ = seed.point[axis];
    *value++ = seed.region + 1;
    *value++ = region < max_volume.size() && max_volume[region] > 0 ? max_volume[region] : kNoVolumeBound;
  }
}

void write_mesh_of(const tetgenio& out, const SurfaceComplex& surface, std::FILE* file) {
  const auto cell_count = static_cast<std::size_t>(out.numberoftetrahedra);
  const auto triangle_count = static_cast<std::size_t>(out.numberoftrifaces);
  const auto stride = static_cast<std::size_t>(out.numberoftetrahedronattributes);
  std::vector<std::int32_t> regions(cell_count, -1);
  int last_region = -1;
  for (const RegionSeed& seed : surface.seeds) last_region = std::max(last_region, seed.region);
  for (std::size_t c = 0; c < cell_count && stride > 0; ++c) {
    // TetGen numbers the parts that no seed has reached on from the largest attribute.
    const double attribute = out.tetrahedronattributelist[c * stride + stride - 1];
    if (attribute >= 1 && attribute <= last_region + 1) regions[c] = static_cast<std::int32_t>(attribute) - 1;
  }
  std::vector<std::int32_t> walls(triangle_count, -1), sheets(triangle_count, -1);
  const auto wall_count = static_cast<int>(surface.wall_names.size());
  const auto sheet_count = static_cast<int>(surface.sheets.size());
  for (std::size_t t = 0; t < triangle_count && out.trifacemarkerlist; ++t) {
    const int marker = out.trifacemarkerlist[t];
    if (marker >= 1 && marker <= wall_count)
      walls[t] = marker - 1;
    else if (marker > wall_count && marker <= wall_count + sheet_count)
      sheets[t] = marker - wall_count - 1;
  }
  write_array(file, std::vector<double>(out.pointlist, out.pointlist + 3 * out.numberofpoints));
  write_array(
      file, std::vector<std::int32_t>(out.tetrahedronlist, out.tetrahedronlist + 4 * out.numberoftetrahedra));
  write_array(file, regions);
  write_array(file, std::vector<std::int32_t>(out.trifacelist, out.trifacelist + 3 * out.numberoftrifaces));
  write_array(file, walls);
  write_array(file, sheets);
}

/// Runs in the child process.
int mesh_to_file(const SurfaceComplex& surface, const std::vector<double>& max_volume,
                 const std::string& switches, std::FILE* file) try {
  tetgenio in;
  tetgenio out;
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(surface.points.size());
  in.pointlist = copied(surface.points);
  set_facets(in, surface);
  set_regions(in, surface, max_volume);
  if (!surface.holes.empty()) {
    in.numberofholes = static_cast<int>(surface.holes.size());
    in.holelist = copied(surface.holes);
  }
  std::string writable_switches = switches;
  ::tetrahedralize(writable_switches.data(), &in, &out);
  write_mesh_of(out, surface, file);
  return 0;
} catch (const std::bad_alloc&) {
  return kOutOfMemory;
}

/// TetGen has said that it adds no more points.
struct PointLimitReached {};

TetGenEnd end_of(const ChildOutcome& child) {
  if (child.signal == SIGINT || child.signal == SIGTERM) return TetGenEnd::interrupted;
  if (child.signal == SIGXCPU) return TetGenEnd::out_of_time;
  if (child.signal == 0 && child.exit_code == 0) return TetGenEnd::done;
  // The system kills what takes the last of its memory.
  if (child.signal == SIGKILL || (child.signal == 0 && child.exit_code == kOutOfMemory))
    return TetGenEnd::out_of_memory;
  const int code = tetgen_code(child.exit_code);
  return child.signal == 0 && code > 0 ? static_cast<TetGenEnd>(code) : TetGenEnd::killed;
}

TetGenMesh mesh_from(std::string_view bytes) {
  TetGenMesh mesh;
  mesh.coordinates = take_array<double>(bytes);
  mesh.cells = take_array<std::int32_t>(bytes);
  mesh.regions = take_array<std::int32_t>(bytes);
  mesh.triangles = take_array<std::int32_t>(bytes);
  mesh.walls = take_array<std::int32_t>(bytes);
  mesh.sheets = take_array<std::int32_t>(bytes);
  return mesh;
}

}  // namespace

TetGenOutcome call_tetgen(const SurfaceComplex& surface, const std::vector<double>& max_volume,
                          const std::string& switches, int most_added, const Log& log,
                          AtPointLimit at_limit) {
  TetGenOutcome outcome;
  outcome.most_seconds =
      kLeastSeconds + kSecondsPerPoint * (static_cast<double>(surface.points.size()) + most_added);
  const auto work = [&](std::FILE* file) {
    limit_processor_seconds(outcome.most_seconds);
    return mesh_to_file(surface, max_volume, switches, file);
  };
  const auto on_line = [&](std::string_view line) {
    if (line.find_first_not_of(" \t") == std::string_view::npos) return;
    outcome.last_words = line;
    if (line.starts_with("Warning:")) outcome.last_warning = line;
    if (log) log("tetgen: " + std::string(line));
    if (at_limit == AtPointLimit::stop && line.find(kPointLimitWords) != std::string_view::npos)
      throw PointLimitReached{};
  };
  try {
    const ChildOutcome child = run_in_child(work, on_line);
    outcome.end = end_of(child);
    if (outcome.end == TetGenEnd::done) outcome.mesh = mesh_from(child.result);
  } catch (const PointLimitReached&) {
    outcome.end = TetGenEnd::point_limit;
  }
  return outcome;
}

}  // namespace etendue
