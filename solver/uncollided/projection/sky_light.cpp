// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/sky_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/parallel/parallel_for.h"
#include "base/quadrature/cell_rule.h"
#include "mesh/tetrahedra/adjacency/vertex_cells.h"
#include "mesh/tetrahedra/bounding_box.h"
#include "mesh/tetrahedra/sheet_faces.h"

namespace etendue {
namespace {

/// Beams whose depths at all vertices are kept at a time.
constexpr std::size_t group = 32;
/// Less than that is nothing, but its logarithm is a number.
constexpr double least_beam_transmittance = 1e-300;
/// Optical depths that differ by less over a cell are seen well enough by four points, by fourteen; where
/// they differ by more the cell is cut in two, so many times at most and not where a trifle of the light is
/// left.
constexpr double even_depth = 0.03, uneven_depth = 1.5, negligible_depth = 15;
constexpr int most_sky_cuts = 9;

/// Optical thickness of a cell from which on fourteen points of it are sampled, else four.
constexpr double thick_for_sky = 0.3;
/// Resolution at which planes are distinct: by their normals, and their places in sizes of the domain.
constexpr double distinct_plane = 1e-6;

/// One beam in one band at the corners of a part of a cell.
struct Corners {
  SubTetrahedron where;
  std::array<double, 4> depth;

  double difference(std::size_t i, std::size_t j) const { return std::abs(depth[i] - depth[j]); }
  double least() const { return *std::ranges::min_element(depth); }
};

using Points = std::vector<std::pair<std::array<double, 4>, double>>;  ///< in the cell, fluence and volume

template <class Rule>
void append_points(const Rule& rule, const Corners& at, double measure, Points& points) {
  for (const auto& point : rule) {
    double depth = 0;
    for (std::size_t i = 0; i < 4; ++i) depth += point.barycentric[i] * at.depth[i];
    points.emplace_back(in_whole(point.barycentric, at.where), point.weight * measure * std::exp(-depth));
  }
}

void append_points(const Corners& at, double measure, double least, int cuts, Points& points) {
  std::size_t p = 0, q = 1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (at.difference(i, j) > at.difference(p, q)) {
        p = i;
        q = j;
      }
  if (at.difference(p, q) < even_depth) return append_points(four_point_rule(), at, measure, points);
  if (at.difference(p, q) < uneven_depth || cuts == 0 || at.least() > least + negligible_depth)
    return append_points(cell_rule(), at, measure, points);
  for (const std::size_t moved : {p, q}) {
    Corners half = at;
    half.depth[moved] = (at.depth[p] + at.depth[q]) / 2;
    for (std::size_t i = 0; i < 4; ++i) half.where[moved][i] = (at.where[p][i] + at.where[q][i]) / 2;
    append_points(half, measure / 2, least, cuts - 1, points);
  }
}

/// [boundary face] The plane that it lies in, numbered.
std::vector<std::int32_t> planes_of_faces(const TetrahedralMesh& mesh) {
  const BoundingBox box = bounding_box(mesh.points());
  std::map<std::array<std::int64_t, 4>, std::int32_t> numbers;
  std::vector<std::int32_t> planes;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const Vec3 normal = mesh.area_normal(FaceIndex(f)).normalized();
    const double place = normal.dot(mesh.centroid(FaceIndex(f)) - box.low) / box.diagonal();
    const auto rounded = [](double value) { return std::llround(value / distinct_plane); };
    planes.push_back(
        numbers
            .try_emplace({rounded(normal.x()), rounded(normal.y()), rounded(normal.z()), rounded(place)},
                         static_cast<std::int32_t>(numbers.size()))
            .first->second);
  }
  return planes;
}

/// Where the paths to the vertices begin.
struct Beginnings {
  std::vector<std::int32_t> planes;  ///< [boundary face]
  std::vector<CellIndex> cells;      ///< [vertex] one of those around it
  std::vector<char> on_sheet;        ///< [vertex]
};

/// Some beams of a sky at the vertices of the mesh, and what they bring to cells.
class BeamGroup {
 public:
  BeamGroup(const LightPaths& paths, const SkySource& sky, const Beginnings& beginnings, std::size_t first,
            int threads, StageCounter& counter)
      : paths_(paths),
        sky_(sky),
        first_(first),
        count_(std::min(group, sky.directions().size() - first)),
        bands_(paths.bands()) {
    for (std::size_t k = 0; k < count_; ++k)
      views_.push_back(paths.matter().view(sky.directions()[first + k]));
    depth_.resize(beginnings.cells.size() * count_ * bands_);
    entry_.assign(beginnings.cells.size() * count_, several_entries);
    parallel_for(
        beginnings.cells.size(), threads, 64, [&] { return std::vector<double>(bands_); },
        [&](std::size_t v, std::vector<double>& transmittance) {
          for (std::size_t k = 0; k < count_ && beginnings.on_sheet[v] == 0; ++k)
            look_from_vertex(beginnings, v, k, transmittance);
          return counter.add();
        });
  }

  void add(const LitCell& cell, NodalMoments& moments) const {
    const auto& vertices = paths_.problem().mesh().vertices(cell.index);
    std::vector<double> transmittance(bands_);
    Points points;
    for (std::size_t k = 0; k < count_; ++k) {
      std::array<std::size_t, 4> place;
      for (std::size_t i = 0; i < 4; ++i) place[i] = static_cast<std::size_t>(vertices[i]) * count_ + k;
      const std::int64_t entry = entry_[place[0]];
      const bool alike = std::ranges::all_of(place, [&](std::size_t p) { return entry_[p] == entry; });
      if (alike && entry == no_entry) continue;
      if (!alike || entry == several_entries) {
        if (cell.thickness < thick_for_sky)
          look(cell, k, four_point_rule(), transmittance, moments);
        else
          look(cell, k, cell_rule(), transmittance, moments);
        continue;
      }
      for (std::size_t b = 0; b < bands_; ++b) {
        Corners at{whole_cell(), {}};
        for (std::size_t i = 0; i < 4; ++i) at.depth[i] = depth_[place[i] * bands_ + b];
        points.clear();
        append_points(at, cell.volume, at.least(), most_sky_cuts, points);
        add(cell, {k, static_cast<std::size_t>(entry % parts())}, b, points, moments);
      }
    }
  }

 private:
  /// In the place of a plane by which a beam comes to a vertex: by none, and by another on each side of a
  /// sheet.
  static constexpr std::int64_t no_entry = -1, several_entries = -2;

  void look_from_vertex(const Beginnings& beginnings, std::size_t v, std::size_t k,
                        std::span<double> transmittance) {
    const auto entry =
        sky_.transmit({beginnings.cells[v], paths_.problem().mesh().points()[v]}, first_ + k, transmittance);
    if (!entry) {
      entry_[v * count_ + k] = no_entry;
      return;
    }
    entry_[v * count_ + k] =
        beginnings.planes[entry->face.at()] * parts() + static_cast<std::int64_t>(sky_.kind(entry->part));
    for (std::size_t b = 0; b < bands_; ++b)
      depth_[(v * count_ + k) * bands_ + b] = -std::log(std::max(transmittance[b], least_beam_transmittance));
  }

  /// By rays.
  template <class Rule>
  void look(const LitCell& cell, std::size_t k, const Rule& rule, std::span<double> transmittance,
            NodalMoments& moments) const {
    for (const auto& point : rule)
      if (const auto entry =
              sky_.transmit({cell.index, cell.position(point.barycentric)}, first_ + k, transmittance))
        for (std::size_t b = 0; b < bands_; ++b)
          add(cell, {k, entry->part}, b, {{point.barycentric, point.weight * cell.volume * transmittance[b]}},
              moments);
  }

  std::int64_t parts() const { return static_cast<std::int64_t>(sky_.parts().size()); }

  /// One of the directions, and the part of the sky that its light is of.
  struct Beam {
    std::size_t k, part;
  };
  void add(const LitCell& cell, Beam beam, std::size_t b, const Points& points, NodalMoments& moments) const {
    const Vec3& direction = sky_.directions()[first_ + beam.k];
    const double irradiance = sky_.parts()[beam.part].irradiance[b];
    const bool with_losses = moments.components() > NodalMoments::collided;
    const bool varies = with_losses && paths_.matter().varies(cell.index);
    PathCoefficients here;
    if (!varies) here = paths_.matter().at(cell.index, b, views_[beam.k]);
    std::array<double, 4> fluence{};
    for (const auto& [shape, measure] : points) {
      for (std::size_t i = 0; i < 4; ++i) fluence[i] += irradiance * measure * shape[i];
      if (!varies) continue;
      here = paths_.matter().at(cell.index, b, views_[beam.k], cell.position(shape));
      moments.add(shape, measure, b, irradiance * here.absorption, NodalMoments::absorbed);
      moments.add(shape, measure, b, irradiance * here.scattering, NodalMoments::collided);
      moments.add_scattered(direction, shape, b, measure * irradiance * here.scattering);
    }
    if (!varies) moments.add_scattered(direction, fluence, b, here.scattering);
    for (std::size_t i = 0; i < 4; ++i) {
      moments.at(i, 0, b) += fluence[i];
      for (std::size_t axis = 0; axis < 3; ++axis)
        moments.at(i, 1 + axis, b) += fluence[i] * direction[static_cast<Eigen::Index>(axis)];
      if (!with_losses || varies) continue;
      moments.at(i, NodalMoments::absorbed, b) += fluence[i] * here.absorption;
      moments.at(i, NodalMoments::collided, b) += fluence[i] * here.scattering;
    }
  }

  const LightPaths& paths_;
  const SkySource& sky_;
  std::size_t first_, count_, bands_;
  std::vector<RayMatter::View> views_;  ///< [beam]
  std::vector<double> depth_;           ///< [vertex][beam][band]
  std::vector<std::int64_t> entry_;     ///< [vertex][beam] by which plane it comes in from what kind of part
};

}  // namespace

void add_sky_light(const LightPaths& paths, const SkySource& sky, const RankShare& own, int threads,
                   StageCounter& counter, const std::function<void(const LitCell&, NodalMoments&)>& begin,
                   const std::function<void(const LitCell&, const NodalMoments&)>& add) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  Beginnings beginnings{planes_of_faces(mesh), cells_of_vertices(mesh), {}};
  beginnings.on_sheet.assign(beginnings.cells.size(), 0);
  for (const std::int32_t v : vertices_of_sheets(mesh)) beginnings.on_sheet[static_cast<std::size_t>(v)] = 1;
  for (std::size_t first = 0; first < sky.directions().size(); first += group) {
    const BeamGroup beams(paths, sky, beginnings, first, threads, counter);
    const bool whole = !counter.stopped() &&
                       parallel_for(
                           static_cast<std::size_t>(mesh.cell_count()), threads, 64,
                           [&] { return NodalMoments(4, paths.matter().empty() ? 4 : 6, paths.bands()); },
                           [&](std::size_t c, NodalMoments& moments) {
                             if (!own.has(c)) return counter.add();
                             const LitCell cell(paths, CellIndex(static_cast<std::int64_t>(c)));
                             moments.clear();
                             begin(cell, moments);
                             beams.add(cell, moments);
                             add(cell, moments);
                             return counter.add();
                           });
    if (!whole) return;
  }
}

std::size_t sky_visits(const TetrahedralMesh& mesh, const SkySource& sky) {
  const std::size_t groups = (sky.directions().size() + group - 1) / group;
  return groups * (static_cast<std::size_t>(mesh.cell_count()) + mesh.points().size());
}

}  // namespace etendue
