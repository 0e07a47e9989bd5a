// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/case_tables.h"
#include "mesh/geometry/primitives/geometry.h"
#include "solver/observe/color/photometric_units.h"

namespace etendue {

using enum KeyType;
using namespace key_range;

namespace {

KeyTable top_keys() {
  KeyTable t("");
  t.key("title", text, {.default_value = "\"\""}, "What the case is called.");
  return t;
}

KeyTable box_keys() {
  KeyTable t("mesh.box");
  t.key("region", text, {}, "Name of the region that fills it; not for a hole.");
  t.key("min", point, {.unit = "length", .need = required}, "Lowest corner.");
  t.key("max", point, {.unit = "length", .need = required}, "Highest corner.");
  t.key("walls", named_sides, {}, "Wall names of the sides xmin … zmax that end up on the outside.");
  t.key("hole", boolean, {.default_value = "false"},
        "Removes the volume; its surface becomes walls NAME.xmin … NAME.zmax.");
  t.key("name", text, {}, "Of a hole: what its walls' names begin with.");
  return t;
}

KeyTable patch_keys() {
  KeyTable t("mesh.patch");
  t.key("wall", text, {.need = required}, "Name of the wall.");
  t.key("min", point, {.unit = "length", .need = required},
        "Lowest corner; agrees with `max` in one coordinate.");
  t.key("max", point, {.unit = "length", .need = required}, "Highest corner.");
  return t;
}

KeyTable sheet_keys() {
  KeyTable t("mesh.sheet");
  t.key("corners", points, {.unit = "length"},
        "Corners of a plane polygon in order; its front is where they are seen counterclockwise.");
  t.key("min", point, {.unit = "length"},
        "Instead of corners: lowest corner of a rectangle; agrees with `max` in one coordinate, and its "
        "front looks along that.");
  t.key("max", point, {.unit = "length"}, "Highest corner.");
  t.key("front", text, {.need = required}, "Wall name of the front.");
  t.key("back", text, {}, "Wall name of the back; without it that of the front.");
  return t;
}

KeyTable band_keys() {
  KeyTable t("bands");
  t.key("names", texts, {.default_value = "[\"grey\"]"}, "One name for each band.");
  t.key("edges", numbers, {.unit = "nm", .range = positive},
        "Wavelengths between the bands, rising or falling; one more than names.");
  t.key("wsgg", text, {.choices = {"bordbar", "smith-1", "smith-2"}},
        "Weighted sum of gray gases for mixtures of water vapour and carbon dioxide, instead of names and "
        "edges: bands clear, gray-1, gray-2 and so on (docs/user/heat.md). bordbar: any molar ratio; smith-1 "
        "and smith-2: ratios 1 and 2.");
  t.key("k_distribution", text, {},
        "CSV file of a k-distribution with lines of temperature [K], absorption [1/(m atm)] and weight, "
        "instead "
        "of wsgg, names and edges: bands gray-1, gray-2 and so on (docs/user/heat.md).");
  t.key("molar_ratio", place_value, {.range = {.lowest = 0.01, .highest = 4}},
        "Of water vapour to carbon dioxide, for bordbar. Where a formula or field is beyond 0.01 to 4 the "
        "nearest "
        "of them is used.");
  return t;
}

}  // namespace

const BoundTable<Units>& unit_table() {
  static const BoundTable<Units> table = [] {
    BoundTable<Units> t("units");
    t.key("length", &Units::length, {}, "m, cm, mm, km or any label.");
    t.key("power", &Units::power, {}, "W, mW, \"1/s\" or any label.");
    t.key("illuminance", &Units::illuminance,
          {.choices = photometric_unit_names(PhotometricDimension::illuminance)},
          "Of the illuminances that sensors write.");
    t.key("luminous_exitance", &Units::luminous_exitance,
          {.choices = photometric_unit_names(PhotometricDimension::luminous_exitance)},
          "Of the luminous exitances that sensors write.");
    t.key("luminance", &Units::luminance,
          {.choices = photometric_unit_names(PhotometricDimension::luminance)},
          "Of the luminances that sensors write.");
    t.key("luminous_flux", &Units::luminous_flux,
          {.choices = photometric_unit_names(PhotometricDimension::luminous_flux)},
          "What the luminous fluxes that sensors write are called.");
    t.key("luminous_intensity", &Units::luminous_intensity,
          {.choices = photometric_unit_names(PhotometricDimension::luminous_intensity)},
          "What their luminous intensities are called.");
    t.key("luminous_energy", &Units::luminous_energy,
          {.choices = photometric_unit_names(PhotometricDimension::luminous_energy)},
          "What the luminous energy of the light in a region is called: lumen seconds or talbots.");
    return t;
  }();
  return table;
}

const BoundTable<MeshCase>& mesh_table() {
  static const BoundTable<MeshCase> table = [] {
    BoundTable<MeshCase> t("mesh");
    t.key("file", text, {},
          "A mesh: Gmsh .msh, .vtu, TetGen .node/.ele/.face, or the folder of an OpenFOAM case.");
    t.key("surface", text, {},
          "A closed surface to fill: TetGen .poly/.smesh, STL, OBJ, PLY, OFF; open ones inside it become "
          "sheets.");
    t.key("max_volume", size_bound, {.unit = "length^3", .range = positive},
          "Largest cell, for all regions or by region; \"*\" means the rest.");
    t.key("edge_length", size_bound, {.unit = "length", .range = positive},
          "The same said as a length a: max_volume = a^3/(6 sqrt 2). One of the two.");
    t.key("quality", &MeshCase::quality, {.range = {.lowest = 1.1}},
          "Largest ratio of a cell's circumradius to its shortest edge.");
    t.key("snap", number, {.default_value = "1e-9", .range = {.lowest = 0, .highest = 1e-3}},
          "Coordinates and radii of bodies, patches and sheets that differ by less than this part of the "
          "geometry's longest side are made equal; --verbose tells.");
    t.key("max_cells", integer, {.range = {.lowest = 1, .highest = 1e9}},
          "Refuse a geometry that needs more cells; without it a million beyond those that the bounds ask "
          "for.");
    t.key("refine", &MeshCase::refine, {.range = {.lowest = 0, .highest = 6}, .former_name = "split"},
          "How often every cell is cut into eight, whatever it comes from; curved walls keep their facets.");
    t.key("scale", &MeshCase::scale, {.range = positive}, "Multiplies the coordinates read from a file.");
    t.key("regions", named_points, {.unit = "length"},
          "Of a surface: a point inside each region, after scaling; without it \"domain\".");
    t.choice("up", &MeshCase::up, {{"y", UpAxis::y}, {"z", UpAxis::z}}, {},
             "The axis that points up in the file; with y it is turned so that z points up.");
    return t;
  }();
  return table;
}

const BoundTable<LabelsCase>& label_table() {
  static const BoundTable<LabelsCase> table = [] {
    BoundTable<LabelsCase> t("mesh.labels");
    t.key("file", text, {.need = required}, "An image of labels: VTK .vti, NIfTI .nii or .nii.gz.");
    t.key("array", &LabelsCase::array, {.default_note = "the only one"},
          "Name of the array; values of points are those of voxels around them.");
    t.key("regions", named_integers,
          {.range = {.lowest = -largest_count, .highest = largest_count}, .need = required},
          "The label of each region; voxels with another one are left out.");
    return t;
  }();
  return table;
}

const BoundTable<SpherePrimitive>& sphere_table() {
  static const BoundTable<SpherePrimitive> table = [] {
    BoundTable<SpherePrimitive> t("mesh.sphere");
    t.key("region", text, {}, "Name of the region that fills it; not for a hole.");
    t.key("center", &SpherePrimitive::center, {.unit = "length", .need = required}, "Centre.");
    t.key("radius", &SpherePrimitive::radius, {.unit = "length", .range = positive, .need = required},
          "Radius.");
    t.key("facets", &SpherePrimitive::facets,
          {.range = {.lowest = SpherePrimitive::fewest_facets, .highest = 1e6}},
          "About how many triangles it is made of.");
    t.key("hole", boolean, {.default_value = "false"},
          "Removes the volume; its surface becomes the wall NAME.");
    t.key("name", text, {}, "Of a hole: its wall's name.");
    return t;
  }();
  return table;
}

const BoundTable<CylinderPrimitive>& cylinder_table() {
  static const BoundTable<CylinderPrimitive> table = [] {
    BoundTable<CylinderPrimitive> t("mesh.cylinder");
    t.key("region", text, {}, "Name of the region that fills it; not for a hole.");
    t.key("from", &CylinderPrimitive::from, {.unit = "length", .need = required}, "Middle of one end.");
    t.key("to", &CylinderPrimitive::to, {.unit = "length", .need = required}, "Middle of the other end.");
    t.key("radius", &CylinderPrimitive::radius, {.unit = "length", .range = positive, .need = required},
          "Radius.");
    t.key("facets", &CylinderPrimitive::facets,
          {.range = {.lowest = CylinderPrimitive::fewest_facets, .highest = 1e5}}, "How many sides it has.");
    t.key("hole", boolean, {.default_value = "false"},
          "Removes the volume; its surface becomes the wall NAME.");
    t.key("name", text, {}, "Of a hole: its wall's name.");
    return t;
  }();
  return table;
}

std::vector<KeyDeclaration> scene_keys() {
  return declarations_of({top_keys(), unit_table(), mesh_table(), label_table(), box_keys(), sphere_table(),
                          cylinder_table(), patch_keys(), sheet_keys(), band_keys()});
}

}  // namespace etendue
