// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/case/keys/case_tables.h"
#include "app/case/keys/resolve_path.h"

namespace etendue {
namespace {

constexpr std::array<std::string_view, 3> primitive_lists = {"box", "sphere", "cylinder"};
constexpr std::array<std::string_view, 6> geometries = {"file", "surface", "labels",
                                                        "box",  "sphere",  "cylinder"};

bool has_primitives(const Section& mesh) {
  for (const std::string_view list : primitive_lists)
    if (mesh.has(list)) return true;
  return false;
}

bool reads_a_file(const Section& mesh) {
  return mesh.has("file") || mesh.has("surface") || mesh.has("labels");
}

// Boxes, spheres and cylinders are one geometry together.
void check_one_geometry(Section& mesh) {
  std::string_view first;
  bool first_primitive = false;
  for (const std::string_view name : geometries) {
    if (!mesh.has(name)) continue;
    const bool primitive = std::ranges::count(primitive_lists, name) > 0;
    if (first.empty()) {
      first = name;
      first_primitive = primitive;
    } else if (!primitive || !first_primitive) {
      mesh.fault(
          name,
          fmt::format("a second geometry (mesh.{} is at line {}); use exactly one of file, surface, labels "
                      "or primitives",
                      first, mesh.origin(first).line));
    }
  }
  if (first.empty() && !mesh.node().faulty)
    mesh.fault("no geometry; use exactly one of file, surface, labels or primitives (box, sphere, cylinder)");
}

std::optional<InputFile> read_file(Section& mesh, const char* name,
                                   const std::filesystem::path& case_folder) {
  const TomlNode* node = mesh.find(name);
  if (node == nullptr) return std::nullopt;
  return InputFile{resolve_path(*node, case_folder), node->origin};
}

std::optional<SizeBound> read_size_bound(Section& mesh, const char* name) {
  const TomlNode* node = mesh.find(name);
  if (node == nullptr) return std::nullopt;
  SizeBound bound;
  bound.origin = node->origin;
  if (node->is_number()) bound.by_region["*"] = node->number();
  if (node->is_table())
    for (const auto& [region, size] : node->table().entries) bound.by_region[region] = size->number();
  return bound;
}

void read_sizes(Section& section, MeshCase& mesh) {
  mesh.max_volume = read_size_bound(section, "max_volume");
  mesh.edge_length = read_size_bound(section, "edge_length");
  if (section.has("max_volume") && section.has("edge_length"))
    section.fault("edge_length", "given beside max_volume (both bound the cells' size); use one of the two");
}

void read_regions(Section& section, MeshCase& mesh) {
  const TomlNode* node = section.find("regions");
  if (node == nullptr) return;
  for (const auto& [region, point] : node->table().entries) mesh.regions[region] = to_vec3(*point);
}

std::optional<LabelsCase> read_labels(Section section, const std::filesystem::path& case_folder) {
  const TomlNode* file = section.find("file");
  const TomlNode* regions = section.find("regions");
  LabelsCase labels;
  label_table().read(section, labels);
  if (file == nullptr || regions == nullptr) return std::nullopt;
  labels.file = {resolve_path(*file, case_folder), file->origin};
  for (const auto& [region, label] : regions->table().entries)
    labels.labels[region] = static_cast<int>(label->number());
  return labels;
}

void reject_unused(Section& mesh) {
  if (mesh.has("file"))
    for (const char* name : {"max_volume", "edge_length", "quality", "max_cells"})
      mesh.unused(name, "the cells of a mesh file stay as they are");
  if (!mesh.has("surface")) mesh.unused("regions", "only a surface takes it");
  if (!reads_a_file(mesh)) {
    mesh.unused("scale", "it multiplies coordinates read from a file");
    mesh.unused("up", "it is that of a file");
  }
  if (!has_primitives(mesh)) {
    mesh.unused("patch", "patches lie on boxes");
    mesh.unused("sheet", "sheets stand among boxes, spheres and cylinders");
    mesh.unused("snap", "it moves boxes, spheres and cylinders");
  }
}

}  // namespace

MeshCase read_mesh_section(Section section, const std::filesystem::path& case_folder) {
  MeshCase mesh;
  mesh.origin = section.origin();
  check_one_geometry(section);
  reject_unused(section);
  mesh_table().read(section, "refine", mesh);
  mesh.file = read_file(section, "file", case_folder);
  mesh.surface = read_file(section, "surface", case_folder);
  mesh.geometry = read_geometry(section);
  if (has_primitives(section)) mesh.geometry.snap = section.number("snap");
  read_regions(section, mesh);
  if (section.has("labels")) mesh.labels = read_labels(section.section("labels"), case_folder);
  if (reads_a_file(section)) {
    for (const char* name : {"scale", "up"}) mesh_table().read(section, name, mesh);
  }
  if (section.has("file")) return mesh;
  read_sizes(section, mesh);
  mesh_table().read(section, "quality", mesh);
  if (section.has("max_cells")) mesh.max_cells = section.integer("max_cells");
  return mesh;
}

}  // namespace etendue
