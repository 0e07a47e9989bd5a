// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/mesh_report.h"

#include <algorithm>
#include <cstdio>

#include <Eigen/Geometry>

#include "base/position.h"
#include "mesh/tetrahedra/mesh_faults.h"

namespace etendue {
namespace {

/// 3 r_in / r_circum with r_in = 3V / sum of areas and r_circum = |a^2 b x c + b^2 c x a + c^2 a x b| / 12V,
/// where a, b, c are the edges from one vertex.
double radius_ratio(const TetrahedralMesh& mesh, CellIndex cell) {
  const auto& v = mesh.vertices(cell);
  const Vec3& origin = mesh.point(VertexIndex(v[0]));
  const Vec3 a = mesh.point(VertexIndex(v[1])) - origin;
  const Vec3 b = mesh.point(VertexIndex(v[2])) - origin;
  const Vec3 c = mesh.point(VertexIndex(v[3])) - origin;
  const double volume = mesh.volume(cell);
  double area = 0;
  for (const std::int32_t face : mesh.faces(cell)) area += mesh.area(FaceIndex(face));
  const double inscribed = 3 * volume / area;
  const Vec3 center =
      a.squaredNorm() * b.cross(c) + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b);
  return 3 * inscribed * 12 * volume / center.norm();
}

void add_cells(MeshReport& report, const TetrahedralMesh& mesh) {
  report.region_volumes.assign(mesh.region_names().size(), 0);
  report.region_cells.assign(mesh.region_names().size(), 0);
  report.smallest_volume = *std::min_element(mesh.volumes().begin(), mesh.volumes().end());
  report.largest_volume = *std::max_element(mesh.volumes().begin(), mesh.volumes().end());
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    report.region_volumes[position(mesh.region(cell))] += mesh.volume(cell);
    ++report.region_cells[position(mesh.region(cell))];
    const double quality = radius_ratio(mesh, cell);
    ++report.quality_histogram[position(std::clamp(static_cast<int>(10 * quality), 0, 9))];
    if (c == 0 || quality < report.worst_quality) {
      report.worst_quality = quality;
      report.worst_centroid = mesh.centroid(cell);
    }
  }
}

void add_walls(MeshReport& report, const TetrahedralMesh& mesh) {
  report.wall_areas.assign(mesh.wall_names().size(), 0);
  report.wall_faces.assign(mesh.wall_names().size(), 0);
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    report.wall_areas[position(mesh.wall(face))] += mesh.area(face);
    ++report.wall_faces[position(mesh.wall(face))];
  }
}

/// One line of a table: a name, a count and a measure.
std::string row(const std::string& name, std::size_t width, const std::string& count,
                const std::string& measure) {
  std::string line = "  " + name + std::string(width - name.size(), ' ');
  line += "  " + std::string(count.size() < 9 ? 9 - count.size() : 0, ' ') + count;
  line += "  " + std::string(measure.size() < 12 ? 12 - measure.size() : 0, ' ') + measure;
  return line + "\n";
}

std::string table(const std::string& title, const std::string& things, const std::string& measure,
                  const std::vector<std::string>& names, const std::vector<int>& counts,
                  const std::vector<double>& measures) {
  std::size_t width = title.size();
  for (const std::string& name : names) width = std::max(width, name.size());
  std::string text = row(title, width, things, measure);
  int count = 0;
  double sum = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += row(names[i], width, std::to_string(counts[i]), to_text(measures[i]));
    count += counts[i];
    sum += measures[i];
  }
  return text + row("sum", width, std::to_string(count), to_text(sum));
}

std::string histogram(const MeshReport& report) {
  constexpr int kBarLength = 40;
  const int largest = *std::max_element(report.quality_histogram.begin(), report.quality_histogram.end());
  std::string text;
  for (std::size_t bin = 0; bin < report.quality_histogram.size(); ++bin) {
    const int count = report.quality_histogram[bin];
    std::array<char, 32> head{};
    std::snprintf(head.data(), head.size(), "  %.1f ... %.1f %9d", static_cast<double>(bin) / 10,
                  static_cast<double>(bin + 1) / 10, count);
    text += head.data();
    const auto length =
        static_cast<std::size_t>(static_cast<long>(kBarLength) * count / std::max(largest, 1));
    if (length > 0) text += " " + std::string(length, '#');
    text += "\n";
  }
  return text;
}

}  // namespace

MeshReport mesh_report(const TetrahedralMesh& mesh) {
  MeshReport report;
  add_cells(report, mesh);
  add_walls(report, mesh);
  return report;
}

std::string to_string(const MeshReport& report, const TetrahedralMesh& mesh, const std::string& length_unit) {
  return std::to_string(mesh.cell_count()) + " cells, " + std::to_string(mesh.face_count()) + " faces, " +
         std::to_string(mesh.vertex_count()) + " vertices\n" +
         table("region", "cells", "volume [" + length_unit + "^3]", mesh.region_names(), report.region_cells,
               report.region_volumes) +
         table("wall", "faces", "area [" + length_unit + "^2]", mesh.wall_names(), report.wall_faces,
               report.wall_areas) +
         "cell volumes from " + to_text(report.smallest_volume) + " to " + to_text(report.largest_volume) +
         " " + length_unit + "^3\n" + "quality (3 inscribed radius / circumscribed radius)\n" +
         histogram(report) + "worst " + to_text(report.worst_quality) + " at " +
         to_text(report.worst_centroid) + "\n";
}

}  // namespace etendue
