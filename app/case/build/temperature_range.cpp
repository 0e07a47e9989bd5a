// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/temperature_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/case/build/entry_of.h"
#include "app/case/values/blackbody_values.h"
#include "app/case/values/mixture_values.h"
#include "app/case/values/value_algebra.h"
#include "mesh/tetrahedra/corners.h"

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

std::vector<Sample> samples_of_region(const TetrahedralMesh& mesh, int region) {
  std::vector<Sample> samples;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (mesh.region(cell) != region) continue;
    const auto corners = corners_of(mesh, cell);
    samples.push_back({{corners.begin(), corners.end()}, mesh.volume(cell)});
  }
  return samples;
}

std::vector<Sample> samples_of_wall(const TetrahedralMesh& mesh, int wall) {
  std::vector<Sample> samples;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (mesh.wall(face) != wall) continue;
    const auto corners = corners_of(mesh, face);
    samples.push_back({{corners.begin(), corners.end()}, mesh.area(face)});
  }
  return samples;
}

/// What to do about a temperature that cannot be; empty where it can.
std::string kelvin_remedy(double kelvin, const Bands& bands) {
  if (!(kelvin >= 0) || !std::isfinite(kelvin)) return "use kelvin, at least 0";
  if (!bands.gas.gases.empty() && kelvin > bands.gas.highest)
    return fmt::format("the gray gases of the bands are known up to {:g} K", bands.gas.highest);
  return "";
}

/// Adds the range of one region or wall, or the fault of the first point where the temperature is none.
void add_range(const BandValues& temperature, const std::string& place, const std::vector<Sample>& samples,
               const Bands& bands, std::vector<TemperatureRange>& ranges, std::vector<Fault>& faults) {
  if (samples.empty()) return;
  const Coefficient kelvin_at = coefficient_of(temperature.values.front());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  TemperatureRange range{place, infinity, -infinity, 0};
  double sum = 0;
  for (const Sample& sample : samples) {
    const double mean = kelvin_at.at(sample.centroid());
    std::vector<Vec3> points = sample.corners;
    points.push_back(sample.centroid());
    for (const Vec3& point : points) {
      const double kelvin = kelvin_at.at(point);
      if (const std::string remedy = kelvin_remedy(kelvin, bands); !remedy.empty())
        return faults.push_back(
            fault_at(temperature.origin, "",
                     fmt::format("the temperature is {:.6g} at ({:.6g}, {:.6g}, {:.6g}) in {}; {}", kelvin,
                                 point.x(), point.y(), point.z(), place, remedy)));
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

/// Ratios at centroids; throws where one is no number.
class MolarRatios {
 public:
  explicit MolarRatios(const BandValues& values)
      : origin_(values.origin), ratio_(coefficient_of(values.values.front())) {}

  double at(const Sample& sample, const std::string& place) const {
    const Vec3 point = sample.centroid();
    const double value = ratio_.at(point);
    if (std::isnan(value))
      throw InputError(fault_at(
          origin_, "",
          fmt::format(
              "no number at ({:.6g}, {:.6g}, {:.6g}) in {}; give any number where there is neither gas "
              "(walls emit by the ratio beside them)",
              point.x(), point.y(), point.z(), place)));
    return value;
  }

 private:
  Origin origin_;
  Coefficient ratio_;
};

}  // namespace

std::vector<TemperatureRange> temperature_ranges(const Case& input, const TetrahedralMesh& mesh) {
  std::vector<TemperatureRange> ranges;
  std::vector<Fault> faults;
  for (std::size_t region = 0; region < mesh.region_names().size(); ++region) {
    const std::string& name = mesh.region_names()[region];
    const MediumCase entry = entry_of(input.media, name);
    for (const auto* temperature : {&entry.temperature, &entry.initial_temperature})
      if (*temperature)
        add_range(**temperature, name, samples_of_region(mesh, static_cast<int>(region)), input.bands, ranges,
                  faults);
  }
  for (std::size_t wall = 0; wall < mesh.wall_names().size(); ++wall) {
    const std::string& name = mesh.wall_names()[wall];
    const WallCase entry = entry_of(input.walls, name);
    for (const auto* temperature : {&entry.temperature, &entry.initial_temperature})
      if (*temperature)
        add_range(**temperature, name, samples_of_wall(mesh, static_cast<int>(wall)), input.bands, ranges,
                  faults);
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return ranges;
}

std::optional<MolarRatioRange> molar_ratio_range(const Case& input, const TetrahedralMesh& mesh) {
  if (!input.molar_ratio) return std::nullopt;
  const MolarRatios ratios(*input.molar_ratio);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  MolarRatioRange range{infinity, -infinity};
  double volume = 0, beyond = 0;
  for (std::size_t region = 0; region < mesh.region_names().size(); ++region) {
    const std::string& name = mesh.region_names()[region];
    const MediumCase entry = entry_of(input.media, name);
    if (!entry.gas_pressure && !entry.temperature) continue;
    for (const Sample& sample : samples_of_region(mesh, static_cast<int>(region))) {
      const double ratio = ratios.at(sample, name);
      range.lowest = std::min(range.lowest, ratio);
      range.highest = std::max(range.highest, ratio);
      volume += sample.weight;
      if (ratio < lowest_molar_ratio || ratio > highest_molar_ratio) beyond += sample.weight;
    }
  }
  for (std::size_t wall = 0; wall < mesh.wall_names().size(); ++wall) {
    const std::string& name = mesh.wall_names()[wall];
    if (!entry_of(input.walls, name).temperature) continue;
    for (const Sample& sample : samples_of_wall(mesh, static_cast<int>(wall))) ratios.at(sample, name);
  }
  if (volume <= 0) return std::nullopt;
  range.beyond = beyond / volume;
  return range;
}

}  // namespace etendue
