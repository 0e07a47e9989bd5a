// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/temperature_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/case/build/entry_of.h"
#include "app/case/values/blackbody_values.h"
#include "base/expression/expression.h"

namespace etendue {
namespace {

/// A cell of a region or a face of a wall, and its volume or area.
struct Sample {
  std::vector<Vec3> corners;
  double weight;

  Vec3 centroid() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& corner : corners) sum += corner;
    return sum / static_cast<double>(corners.size());
  }
};

class TemperatureAt {
 public:
  explicit TemperatureAt(const Value& value) {
    if (const double* number = std::get_if<double>(&value))
      number_ = *number;
    else
      formula_.emplace(std::get<Formula>(value), std::vector<std::string>{"x", "y", "z"});
  }
  double operator()(const Vec3& p) const {
    return formula_ ? (*formula_)(std::array{p.x(), p.y(), p.z()}) : number_;
  }

 private:
  double number_ = 0;
  std::optional<Expression> formula_;
};

template <class Vertices>
std::vector<Vec3> points_of(const TetrahedralMesh& mesh, const Vertices& vertices) {
  std::vector<Vec3> points;
  for (const std::int32_t v : vertices) points.push_back(mesh.point(VertexIndex(v)));
  return points;
}

std::vector<Sample> samples_of_region(const TetrahedralMesh& mesh, int region) {
  std::vector<Sample> samples;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (mesh.region(cell) != region) continue;
    samples.push_back({points_of(mesh, mesh.vertices(cell)), mesh.volume(cell)});
  }
  return samples;
}

std::vector<Sample> samples_of_wall(const TetrahedralMesh& mesh, int wall) {
  std::vector<Sample> samples;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (mesh.wall(face) != wall) continue;
    samples.push_back({points_of(mesh, mesh.vertices(face)), mesh.area(face)});
  }
  return samples;
}

/// Adds the range of one region or wall, or the fault of the first point where the temperature is none.
void add_range(const BandValues& temperature, const std::string& place, const std::vector<Sample>& samples,
               const Bands& bands, std::vector<TemperatureRange>& ranges, std::vector<Fault>& faults) {
  if (samples.empty()) return;
  const TemperatureAt at(temperature.values.front());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  TemperatureRange range{place, infinity, -infinity, 0};
  double sum = 0;
  for (const Sample& sample : samples) {
    const double mean = at(sample.centroid());
    std::vector<Vec3> points = sample.corners;
    points.push_back(sample.centroid());
    for (const Vec3& point : points) {
      const double kelvin = at(point);
      if (!(kelvin >= 0) || !std::isfinite(kelvin))
        return faults.push_back(fault_at(
            temperature.origin, "",
            fmt::format("the temperature is {:.6g} at ({:.6g}, {:.6g}, {:.6g}) in {}; use kelvin, at least 0",
                        kelvin, point.x(), point.y(), point.z(), place)));
      range.lowest = std::min(range.lowest, kelvin);
      range.highest = std::max(range.highest, kelvin);
    }
    range.mean += mean * sample.weight;
    sum += sample.weight;
  }
  range.mean /= sum;
  range.fraction_in_bands = 1 - fraction_outside_bands(range.mean, bands);
  ranges.push_back(std::move(range));
}

}  // namespace

std::vector<TemperatureRange> temperature_ranges(const Case& input, const TetrahedralMesh& mesh) {
  std::vector<TemperatureRange> ranges;
  std::vector<Fault> faults;
  for (std::size_t region = 0; region < mesh.region_names().size(); ++region) {
    const std::string& name = mesh.region_names()[region];
    if (const MediumCase entry = entry_of(input.media, name); entry.temperature)
      add_range(*entry.temperature, name, samples_of_region(mesh, static_cast<int>(region)), input.bands,
                ranges, faults);
  }
  for (std::size_t wall = 0; wall < mesh.wall_names().size(); ++wall) {
    const std::string& name = mesh.wall_names()[wall];
    if (const WallCase entry = entry_of(input.walls, name); entry.temperature)
      add_range(*entry.temperature, name, samples_of_wall(mesh, static_cast<int>(wall)), input.bands, ranges,
                faults);
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return ranges;
}

}  // namespace etendue
