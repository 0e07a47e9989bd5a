// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/mesh_names.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/edit_distance.h"
#include "app/case/toml_node.h"

namespace etendue {
namespace {

constexpr const char* rest = "*";

/// Compares the names of one kind, regions or walls, in the case with those that there are.
class NameCheck {
 public:
  NameCheck(std::string_view kind, const std::set<std::string>& there, std::vector<Fault>& faults)
      : kind_(kind), there_(there.begin(), there.end()), faults_(faults) {}

  void used(const std::string& name, const Origin& origin) {
    if (name == rest || name.empty() || std::ranges::count(there_, name) > 0) return;
    const std::string meant = closest_name(name, there_);
    const std::string question = meant.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", meant);
    faults_.push_back(fault_at(origin, "",
                               fmt::format("no {} of the mesh is called \"{}\"{}; there are {}", kind_, name,
                                           question, fmt::join(there_, ", "))));
  }

  template <class Entry>
  void entries(const std::map<std::string, Entry>& entries, const std::string& file,
               const std::string& table) {
    for (const auto& [name, entry] : entries) used(name, entry.origin);
    if (entries.contains(rest)) return;
    for (const std::string& name : there_)
      if (!entries.contains(name))
        faults_.push_back(
            fault_at({file, 0, dotted_key(table, name)}, "",
                     fmt::format("missing (the mesh has this {}); add an entry for it, or \"*\"", kind_)));
  }

 private:
  std::string_view kind_;
  std::vector<std::string> there_;
  std::vector<Fault>& faults_;
};

Origin below(const Origin& origin, std::string_view key) {
  return {origin.file, origin.line, dotted_key(origin.key, key)};
}

void check_sizes(const std::optional<SizeBound>& bound, NameCheck& regions) {
  if (!bound) return;
  for (const auto& [name, size] : bound->by_region) regions.used(name, below(bound->origin, name));
}

void check_geometry(const Geometry& geometry, NameCheck& regions, NameCheck& walls) {
  for (const Primitive& primitive : geometry.primitives) {
    const auto& base = std::visit([](const auto& any) -> const PrimitiveBase& { return any; }, primitive);
    regions.used(base.region, below(base.origin, "region"));
    if (const auto* box = std::get_if<BoxPrimitive>(&primitive))
      for (const auto& [side, name] : box->walls) walls.used(name, below(below(base.origin, "walls"), side));
  }
  for (const Patch& patch : geometry.patches) walls.used(patch.wall, below(patch.origin, "wall"));
}

}  // namespace

MeshNames names_of(const SurfaceComplex& surface) {
  MeshNames names;
  for (const RegionSeed& seed : surface.seeds)
    names.regions.insert(surface.region_names[static_cast<std::size_t>(seed.region)]);
  for (const SurfaceFacet& facet : surface.facets)
    if (facet.wall >= 0) names.walls.insert(surface.wall_names[static_cast<std::size_t>(facet.wall)]);
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
  NameCheck regions("region", names.regions, faults), walls("wall", names.walls, faults);
  check_sizes(input.mesh.max_volume, regions);
  check_sizes(input.mesh.edge_length, regions);
  check_geometry(input.mesh.geometry, regions, walls);
  regions.entries(input.media, input.file.string(), "media");
  walls.entries(input.walls, input.file.string(), "walls");
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace etendue
