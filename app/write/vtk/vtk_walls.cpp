// SPDX-License-Identifier: AGPL-3.0-or-later
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include "app/case/temperatures.h"
#include "app/write/result/temperature_fields.h"
#include "app/write/result/unit_labels.h"
#include "app/write/vtk/separate_parts.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_files.h"
#include "app/write/vtk/vtk_output.h"

namespace etendue {
namespace {

std::vector<double> differences(std::span<const double> a, std::span<const double> b) {
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
  return result;
}

std::vector<double> sums_over_bands(std::span<const double> values, std::size_t bands) {
  std::vector<double> sums(values.size() / bands, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) sums[i / bands] += values[i];
  return sums;
}

/// [triangle][3][3][band] values [triangle][3][band] times the unit normal of their triangle.
std::vector<double> along_normals(std::span<const double> values, std::span<const Vec3> normals,
                                  std::size_t bands) {
  std::vector<double> vectors;
  vectors.reserve(3 * values.size());
  for (std::size_t at = 0; at < values.size(); at += bands)
    for (const double component : normals[at / (3 * bands)])
      for (const double value : values.subspan(at, bands)) vectors.push_back(component * value);
  return vectors;
}

/// [triangle][3] temperature of the walls [K], 0 where the case gives none.
std::vector<double> temperatures_at_corners(const RunResult& result, const std::vector<std::int32_t>& walls,
                                            vtkPolyData& surface, std::span<const double> irradiance) {
  const std::vector<WallTemperature> of_walls = wall_temperatures(result);
  const auto bands = static_cast<std::size_t>(result.problem.band_count());
  std::vector<double> kelvin;
  for (std::size_t i = 0; i < 3 * walls.size(); ++i) {
    const double* point = surface.GetPoint(static_cast<vtkIdType>(i));
    kelvin.push_back(of_walls[static_cast<std::size_t>(walls[i / 3])].at(Vec3(point[0], point[1], point[2]),
                                                                         irradiance[i * bands], i));
  }
  return kelvin;
}

/// Light on triangles with three values of their own each.
struct TriangleLight {
  vtkSmartPointer<vtkPolyData> surface;
  std::vector<std::int32_t> walls;
  std::vector<double> irradiance, exitance;  ///< [triangle][3][band]
  std::vector<double> areas;
  std::vector<Vec3> normals;  ///< [triangle] unit, out of the domain
};

TriangleLight light_on_faces(const RunResult& result) {
  const TetrahedralMesh& mesh = result.problem.mesh();
  TriangleLight light;
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    light.walls.push_back(mesh.wall(face));
    light.areas.push_back(mesh.area(face));
    light.normals.push_back(mesh.area_normal(face).normalized());
  }
  light.surface = separate_faces(mesh);
  light.irradiance = result.solution.irradiance;
  light.exitance = result.solution.exitance;
  return light;
}

TriangleLight light_on_triangles(const PatchLight& patches) {
  TriangleLight light;
  std::vector<double> coordinates;
  for (const TriangleCorners& triangle : patches.triangles) {
    for (const Vec3& corner : triangle) coordinates.insert(coordinates.end(), corner.begin(), corner.end());
    const Vec3 area_normal = (triangle[2] - triangle[0]).cross(triangle[1] - triangle[0]) / 2;
    light.areas.push_back(area_normal.norm());
    light.normals.push_back(area_normal.normalized());
  }
  const std::size_t count = patches.triangles.size(), bands = patches.irradiance.size() / count;
  const auto at_corners = [&](const std::vector<double>& values) {
    std::vector<double> repeated;
    for (std::size_t t = 0; t < count; ++t)
      for (int i = 0; i < 3; ++i)
        for (std::size_t b = 0; b < bands; ++b) repeated.push_back(values[t * bands + b]);
    return repeated;
  };
  light.surface = separate_triangles(coordinates, {count, {0, 2, 1}});
  light.surface->GetCellData()->AddArray(vtk_array({"patch", {}, {}}, patches.patches));
  light.walls = patches.walls;
  light.irradiance = at_corners(patches.irradiance);
  light.exitance = at_corners(patches.exitance);
  return light;
}

vtkSmartPointer<vtkPolyData> fields_of_walls(const RunResult& result) {
  const TetrahedralMesh& mesh = result.problem.mesh();
  const Bands& bands = result.problem.bands();
  const std::string unit = UnitLabels(result.input.units).flux;
  const TriangleLight light = result.patches ? light_on_triangles(*result.patches) : light_on_faces(result);
  add_named_cells(*light.surface, "wall", light.walls, mesh.wall_names());
  add_bands(*light.surface->GetFieldData(), bands);
  const auto add = [&](const std::string& name, std::span<const double> values) {
    light.surface->GetPointData()->AddArray(vtk_array({name, bands.names, unit}, bands.count(), values));
  };
  add("irradiance", light.irradiance);
  if (result.errors) add("irradiance_error", result.errors->irradiance);
  add("exitance", light.exitance);
  const std::vector<double> net = differences(light.irradiance, light.exitance);
  add("net_irradiance", net);
  if (has_temperatures(result.input)) {
    light.surface->GetPointData()->AddArray(
        vtk_array({"radiative_heat_flux", {}, unit}, 1, sums_over_bands(net, bands.names.size())));
    light.surface->GetPointData()->AddArray(
        vtk_array({"temperature", {}, "K"}, 1,
                  temperatures_at_corners(result, light.walls, *light.surface, light.irradiance)));
  }
  add_band_vectors(*light.surface->GetPointData(), {"net_flux", bands.names, unit},
                   along_normals(net, light.normals, bands.names.size()));
  light.surface->GetPointData()->AddArray(color_array(bands, light.exitance, light.areas, 3, unit));
  return light.surface;
}

}  // namespace

void write_walls(const RunResult& result, const std::filesystem::path& path,
                 const std::filesystem::path& shown) {
  const Case& input = result.input;
  write_vtk(*fields_of_walls(result), {path, shown, input.output.encoding, input.title, input.units.length});
}

}  // namespace etendue
