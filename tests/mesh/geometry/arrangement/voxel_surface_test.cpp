// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/voxel_surface.h"

#include <gtest/gtest.h>

#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "tests/mesh/geometry/mesh_measures.h"

namespace etendue::voxel_surface_test {
namespace {

/// Layered tissue, 8 x 8 x 6 voxels of 0.5 x 0.5 x 0.25: skin (2) above fat (5), a round tumour (7) in the
/// fat, and voxels of air (0) that are missing from the skin's surface.
FieldData tissue() {
  FieldData image;
  ImageGrid& grid = image.image.emplace();
  grid.origin = Vec3(-2, -2, 0);
  grid.steps = Vec3(0.5, 0.5, 0.25).asDiagonal();
  grid.points = {9, 9, 7};
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i) {
        int label = k < 4 ? 5 : 2;
        if (Vec3(i - 3.5, j - 3.5, k - 2).norm() < 2) label = 7;
        if (k == 5 && i > 5 && j > 4) label = 0;
        image.values.push_back(label);
      }
  return image;
}

const std::map<std::string, int> labels = {{"skin", 2}, {"fat", 5}, {"tumour", 7}};

TetrahedralMesh meshed(const VoxelSurface& voxels) {
  RawMesh raw = tetrahedralize(voxels.surface, {});
  for (Vec3& point : raw.points) point = voxels.origin + voxels.axes * point;
  return TetrahedralMesh(raw);
}

double voxel_volume(const FieldData& image, int label) {
  return 0.5 * 0.5 * 0.25 * static_cast<double>(std::ranges::count(image.values, label));
}

TEST(VoxelSurface, IsMeshedWithTheVolumesOfTheVoxels) {
  const FieldData image = tissue();
  const TetrahedralMesh mesh = meshed(voxel_surface(image, labels, {}));
  const auto volumes = region_volumes(mesh);
  ASSERT_EQ(volumes.size(), labels.size());
  for (const auto& [name, label] : labels)
    EXPECT_NEAR(volumes.at(name), voxel_volume(image, label), 1e-12) << name;
}

TEST(VoxelSurface, NamesTheSidesOfTheImageAndTheSurface) {
  const TetrahedralMesh mesh = meshed(voxel_surface(tissue(), labels, {}));
  const auto areas = wall_area_normals(mesh);
  ASSERT_EQ(areas.size(), 7U);
  EXPECT_NEAR((areas.at("zmin") - Vec3(0, 0, -16)).norm(), 0, 1e-12);
  EXPECT_NEAR((areas.at("zmax") - Vec3(0, 0, 16 - 6 * 0.25)).norm(), 0, 1e-12);
  EXPECT_NEAR((areas.at("xmin") - Vec3(-6, 0, 0)).norm(), 0, 1e-12);
  // Of two by three missing voxels: their floor, and their two sides.
  EXPECT_NEAR((areas.at("surface") - Vec3(3 * 0.125, 2 * 0.125, 6 * 0.25)).norm(), 0, 1e-12);
}

TEST(VoxelSurface, LeavesOutVoxelsThatAreShutIn) {
  FieldData image = tissue();
  const TetrahedralMesh mesh = meshed(voxel_surface(image, {{"skin", 2}, {"fat", 5}}, {}));
  EXPECT_EQ(region_volumes(mesh).size(), 2U);
  double total = 0;
  for (const double volume : mesh.volumes()) total += volume;
  EXPECT_NEAR(total, voxel_volume(image, 2) + voxel_volume(image, 5), 1e-12);
}

TEST(VoxelSurface, TakesPointsForTheMiddlesOfVoxels) {
  FieldData image = tissue();
  image.on = FieldValues::on_points;
  image.image->points = {8, 8, 6};
  image.image->origin += 0.5 * image.image->steps * Vec3::Ones();
  const VoxelSurface of_points = voxel_surface(image, labels, {}),
                     of_cells = voxel_surface(tissue(), labels, {});
  EXPECT_NEAR((of_points.origin - of_cells.origin).norm(), 0, 1e-14);
  EXPECT_EQ(of_points.surface.points, of_cells.surface.points);
}

TEST(VoxelSurface, OfAnImageThatIsTurnedAndMirroredKeepsVolumesAndNamesSidesInSpace) {
  FieldData image = tissue();
  // The first index runs down, the second along -x and up a little, the third along y.
  const double c = std::cos(0.2), s = std::sin(0.2);
  image.image->steps.col(0) = 0.5 * Vec3(s, 0, -c);
  image.image->steps.col(1) = 0.5 * Vec3(-c, 0, -s);
  image.image->steps.col(2) = 0.25 * Vec3(0, 1, 0);
  const TetrahedralMesh mesh = meshed(voxel_surface(image, labels, {}));
  const auto volumes = region_volumes(mesh);
  for (const auto& [name, label] : labels)
    EXPECT_NEAR(volumes.at(name), voxel_volume(image, label), 1e-12) << name;
  const auto areas = wall_area_normals(mesh);
  EXPECT_NEAR((areas.at("ymin") - Vec3(0, -16, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((areas.at("zmax") - 6 * Vec3(-s, 0, c)).norm(), 0, 1e-12);
  EXPECT_NEAR((areas.at("xmax") - 6 * Vec3(c, 0, s)).norm(), 0, 1e-12);
}

TEST(VoxelSurface, OfLayersIsAsCoarseAsTheirBoundaries) {
  FieldData layers = tissue();
  for (std::size_t v = 0; v < layers.values.size(); ++v) layers.values[v] = v < 4 * 64 ? 5 : 2;
  const VoxelSurface voxels = voxel_surface(layers, {{"skin", 2}, {"fat", 5}}, {});
  EXPECT_EQ(voxels.surface.points.size(), 12U);
  EXPECT_EQ(voxels.surface.facets.size(), 11U);
  const VoxelSurface fine = voxel_surface(layers, {{"skin", 2}, {"fat", 5}}, {}, FacetSize::elementary);
  EXPECT_EQ(fine.surface.facets.size(), 3U * 64 + 4 * 8 * 6);
  EXPECT_NEAR(region_volumes(meshed(fine)).at("skin"), voxel_volume(layers, 2), 1e-12);
}

std::string fault_of(const FieldData& image, const std::map<std::string, int>& with) {
  try {
    voxel_surface(image, with, {"case.toml", 4, "mesh.labels.file"});
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(VoxelSurface, RefusesLabelsThatAreMissingTwiceOrNotWhole) {
  FieldData image = tissue();
  EXPECT_EQ(fault_of(image, {{"bone", 9}}),
            "case.toml:4: mesh.labels.file: no voxel has the label 9 (region bone)");
  EXPECT_EQ(fault_of(image, {{"a", 2}, {"b", 2}}),
            "case.toml:4: mesh.labels.file: the label 2 is given to two regions");
  image.values[3] = 1.5;
  EXPECT_EQ(fault_of(image, labels),
            "case.toml:4: mesh.labels.file: voxel 3 has the value 1.5; labels are whole numbers");
}

}  // namespace
}  // namespace etendue::voxel_surface_test
