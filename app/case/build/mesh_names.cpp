// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/mesh_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/case/toml/toml_node.h"
#include "base/text/edit_distance.h"

namespace etendue {
namespace {

constexpr const char* all_others = "*";
constexpr std::array<const char*, 6> sides_of_a_box = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};

/// What a fault says of a name that is not among those there are.
struct Wording {
  std::string_view unknown;
  std::string_view others;
};
constexpr Wording of_a_mesh = {"of the mesh is called", "there are"};
constexpr Wording of_primitives = {"can be called", "there can be"};

/// Compares the names of one kind, regions or walls, in the case with those that there are.
class NameCheck {
 public:
  NameCheck(std::string_view kind, const std::set<std::string>& there, const Wording& wording,
            std::vector<Fault>& faults)
      : kind_(kind), there_(there.begin(), there.end()), wording_(wording), faults_(faults) {}

  void used(const std::string& name, const Origin& origin) {
    if (name == all_others || name.empty() || std::ranges::count(there_, name) > 0) return;
    const std::string meant = closest_name(name, there_);
    const std::string question = meant.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", meant);
    faults_.push_back(fault_at(origin, "",
                               fmt::format("no {} {} \"{}\"{}; {} {}", kind_, wording_.unknown, name,
                                           question, wording_.others, fmt::join(there_, ", "))));
  }

  template <class Entry>
  void all_used(const std::map<std::string, Entry>& entries) {
    for (const auto& [name, entry] : entries) used(name, entry.origin);
  }

  template <class Entry>
  void entries(const std::map<std::string, Entry>& entries, const std::string& file,
               const std::string& table) {
    all_used(entries);
    if (entries.contains(all_others)) return;
    for (const std::string& name : there_)
      if (!entries.contains(name))
        faults_.push_back(
            fault_at({file, 0, dotted_key(table, name)}, "",
                     fmt::format("missing (the mesh has this {}); add an entry for it, or \"*\"", kind_)));
  }

 private:
  std::string_view kind_;
  std::vector<std::string> there_;
  Wording wording_;
  std::vector<Fault>& faults_;
};

Origin below(const Origin& origin, std::string_view key) {
  return {origin.file, origin.line, dotted_key(origin.key, key)};
}

void check_sizes(const MeshCase& mesh, NameCheck& regions) {
  for (const auto& bound : {mesh.max_volume, mesh.edge_length})
    if (bound)
      for (const auto& [name, size] : bound->by_region) regions.used(name, below(bound->origin, name));
}

const PrimitiveBase& base_of(const Primitive& primitive) {
  return std::visit([](const auto& any) -> const PrimitiveBase& { return any; }, primitive);
}

void check_geometry(const Geometry& geometry, NameCheck& regions, NameCheck& walls) {
  for (const Primitive& primitive : geometry.primitives) {
    const PrimitiveBase& base = base_of(primitive);
    regions.used(base.region, below(base.origin, "region"));
    if (const auto* box = std::get_if<BoxPrimitive>(&primitive))
      for (const auto& [side, name] : box->walls) walls.used(name, below(below(base.origin, "walls"), side));
  }
  for (const Patch& patch : geometry.patches) walls.used(patch.wall, below(patch.origin, "wall"));
  for (const Sheet& sheet : geometry.sheets) {
    walls.used(sheet.front, below(sheet.origin, "front"));
    walls.used(sheet.back, below(sheet.origin, "back"));
  }
}

void check_lit_walls(const std::vector<LightCase>& lights, NameCheck& walls) {
  for (const LightCase& light : lights)
    for (const std::string& wall : light.walls) walls.used(wall, below(light.origin, "walls"));
}

// A box names its sides, a hole its surface, and what neither they nor a patch name is named by its
// axis.
MeshNames possible_names(const Geometry& geometry) {
  MeshNames names;
  names.walls.insert(sides_of_a_box.begin(), sides_of_a_box.end());
  for (const Patch& patch : geometry.patches) names.walls.insert(patch.wall);
  for (const Sheet& sheet : geometry.sheets) names.walls.insert({sheet.front, sheet.back});
  for (const Primitive& primitive : geometry.primitives) {
    const PrimitiveBase& base = base_of(primitive);
    const auto* box = std::get_if<BoxPrimitive>(&primitive);
    if (!base.hole) {
      names.regions.insert(base.region);
      if (box)
        for (const auto& [side, wall] : box->walls) names.walls.insert(wall);
    } else if (box) {
      for (const char* side : sides_of_a_box) names.walls.insert(base.name + "." + side);
    } else {
      names.walls.insert(base.name);
    }
  }
  return names;
}

}  // namespace

MeshNames names_of(const SurfaceComplex& surface) {
  MeshNames names;
  for (const RegionSeed& seed : surface.seeds)
    names.regions.insert(surface.region_names[static_cast<std::size_t>(seed.region)]);
  for (const SurfaceFacet& facet : surface.facets)
    if (facet.wall >= 0) names.walls.insert(surface.wall_names[static_cast<std::size_t>(facet.wall)]);
  for (const SurfaceSheet& sheet : surface.sheets)
    for (const int wall : {sheet.front, sheet.back})
      names.walls.insert(surface.wall_names[static_cast<std::size_t>(wall)]);
  return names;
}

MeshNames names_of(const TetrahedralMesh& mesh) {
  MeshNames names;
  for (const std::int32_t region : mesh.cell_regions())
    names.regions.insert(mesh.region_names()[static_cast<std::size_t>(region)]);
  for (const std::int32_t wall : mesh.face_walls())
    names.walls.insert(mesh.wall_names()[static_cast<std::size_t>(wall)]);
  return names;
}

void check_names(const Case& input, const MeshNames& names) {
  std::vector<Fault> faults;
  NameCheck regions("region", names.regions, of_a_mesh, faults),
      walls("wall", names.walls, of_a_mesh, faults);
  check_sizes(input.mesh, regions);
  check_geometry(input.mesh.geometry, regions, walls);
  check_lit_walls(input.lights, walls);
  regions.entries(input.media, input.file.string(), "media");
  walls.entries(input.walls, input.file.string(), "walls");
  if (!faults.empty()) throw InputError(std::move(faults));
}

void check_possible_names(const Case& input, std::vector<Fault>& faults) {
  if (input.mesh.file || input.mesh.surface || input.mesh.labels) return;
  const MeshNames names = possible_names(input.mesh.geometry);
  NameCheck regions("region", names.regions, of_primitives, faults),
      walls("wall", names.walls, of_primitives, faults);
  check_sizes(input.mesh, regions);
  check_lit_walls(input.lights, walls);
  regions.all_used(input.media);
  walls.all_used(input.walls);
}

}  // namespace etendue
