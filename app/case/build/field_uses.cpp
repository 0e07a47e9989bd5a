// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/field_uses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "app/case/build/entry_of.h"
#include "solver/materials/media/coefficient.h"
#include "solver/materials/media/sampled_field.h"

namespace etendue {
namespace {

using Functions = std::set<const PlaceFunction*>;
/// Takes points and their parts of a region or wall [length^3 or length^2].
using TakeNode = std::function<void(const Vec3& point, double weight)>;

Functions functions_in(const BandValues& values) {
  Functions functions;
  for (const Value& value : values.values)
    if (const auto* formula = std::get_if<Formula>(&value))
      for (const auto& [name, function] : formula->functions) functions.insert(function.get());
  return functions;
}

/// Gives the points and weights that integrate a coefficient over the cells of a region.
void give_nodes(const TetrahedralMesh& mesh, int region, const Coefficient& coefficient,
                const TakeNode& take) {
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (mesh.region(cell) != region) continue;
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
    for (const CellRulePoint& node : coefficient.rule(corners))
      take(point_at(node.barycentric, corners), node.weight * mesh.volume(cell));
  }
}

void give_wall_corners(const TetrahedralMesh& mesh, int wall, const TakeNode& take) {
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (mesh.wall(face) != wall) continue;
    for (const std::int32_t v : mesh.vertices(face)) take(mesh.point(VertexIndex(v)), mesh.area(face) / 3);
  }
}

/// Why a field on the cells of the mesh's own file is not where these are; empty where it is.
std::string displacement(const PlaceFunction& function, const MeshCase& mesh) {
  const auto* field = dynamic_cast<const SampledField*>(&function);
  std::error_code ignored;
  if (field == nullptr || !mesh.file ||
      !std::filesystem::equivalent(field->source().file, mesh.file->path, ignored))
    return "";
  if (mesh.up == UpAxis::y)
    return "is of the mesh's own file, which mesh.up turns, and fields are not turned; turn the mesh itself";
  if (field->source().length_scale == mesh.scale) return "";
  return fmt::format(
      "is of the mesh's own file, which mesh.scale = {:g} scales; give the field length_scale = {:g}",
      mesh.scale, mesh.scale);
}

/// The fields of a case, use by use.
class Uses {
 public:
  explicit Uses(const MeshCase& mesh) : mesh_(mesh) {}

  template <class Give>
  void add(const PlaceFunction& function, const char* key, const std::string& place, const Origin& origin,
           const Give& give) {
    if (const std::string problem = displacement(function, mesh_); !problem.empty())
      return faults_.push_back(fault_at(origin, "", function.name() + " " + problem));
    FieldUse use{function.name(), key, place, HUGE_VAL, -HUGE_VAL, 0};
    double sum = 0;
    std::optional<Vec3> uncovered;
    give([&](const Vec3& point, double weight) {
      if (uncovered) return;
      const double value = function.at(point);
      if (!std::isfinite(value) && !function.covers(point)) uncovered = point;
      use.smallest = std::min(use.smallest, value);
      use.largest = std::max(use.largest, value);
      use.mean += weight * value;
      sum += weight;
    });
    if (uncovered)
      return faults_.push_back(fault_at(
          origin, "",
          fmt::format("{} does not cover {} (not at ({:.6g}, {:.6g}, {:.6g})); use a file that does, another "
                      "length_scale, or give the value `outside`",
                      use.field, place, uncovered->x(), uncovered->y(), uncovered->z())));
    if (sum <= 0) return;
    use.mean /= sum;
    uses_.push_back(std::move(use));
  }

  std::vector<FieldUse> all() {
    if (!faults_.empty()) throw InputError(std::move(faults_));
    return std::move(uses_);
  }

 private:
  const MeshCase& mesh_;
  std::vector<FieldUse> uses_;
  std::vector<Fault> faults_;
};

struct Key {
  std::optional<BandValues> MediumCase::*values;
  const char* name;
};
// The absorption has the fields of the pressure too.
constexpr std::array<Key, 12> medium_fields = {{{&MediumCase::gas_pressure, "gas_pressure"},
                                                {&MediumCase::absorption, "absorption"},
                                                {&MediumCase::scattering, "scattering"},
                                                {&MediumCase::extinction, "extinction"},
                                                {&MediumCase::albedo, "albedo"},
                                                {&MediumCase::temperature, "temperature"},
                                                {&MediumCase::heat_source, "heat_source"},
                                                {&MediumCase::conductivity, "conductivity"},
                                                {&MediumCase::heat_capacity, "heat_capacity"},
                                                {&MediumCase::initial_temperature, "initial_temperature"},
                                                {&MediumCase::emission, "emission"},
                                                {&MediumCase::power_density, "power_density"}}};

void add_medium(const MediumCase& medium, const std::optional<BandValues>& molar_ratio,
                const TetrahedralMesh& mesh, int region, Uses& uses) {
  Functions seen;  // leaves and flakes make two coefficients of one field, gases have several in one
  const auto add = [&](const BandValues& values, const char* key) {
    for (const PlaceFunction* function : functions_in(values)) {
      if (!seen.insert(function).second) continue;
      // Not owned: it lives as long as the case.
      const Coefficient alone(
          Expression(Formula("f(x,y,z)", {{"f", {std::shared_ptr<void>(), function}}}), {"x", "y", "z"}));
      uses.add(*function, key, mesh.region_names()[static_cast<std::size_t>(region)], values.origin,
               [&](const TakeNode& take) { give_nodes(mesh, region, alone, take); });
    }
  };
  if (molar_ratio && (medium.gas_pressure || medium.temperature)) add(*molar_ratio, "molar_ratio");
  for (const Key& key : medium_fields)
    if (const std::optional<BandValues>& values = medium.*key.values) add(*values, key.name);
}

}  // namespace

std::vector<FieldUse> field_uses(const Case& input, const TetrahedralMesh& mesh) {
  Uses uses(input.mesh);
  const Functions of_mixture = input.molar_ratio ? functions_in(*input.molar_ratio) : Functions();
  for (std::size_t region = 0; region < mesh.region_names().size(); ++region)
    add_medium(entry_of(input.media, mesh.region_names()[region]), input.molar_ratio, mesh,
               static_cast<int>(region), uses);
  for (std::size_t wall = 0; wall < mesh.wall_names().size(); ++wall) {
    const WallCase entry = entry_of(input.walls, mesh.wall_names()[wall]);
    for (const PlaceFunction* function : functions_in(entry.radiance)) {
      const bool of_ratio = of_mixture.contains(function);
      uses.add(*function,
               of_ratio            ? "molar_ratio"
               : entry.temperature ? "temperature"
                                   : "radiance",
               mesh.wall_names()[wall], of_ratio ? input.molar_ratio->origin : entry.radiance.origin,
               [&](const TakeNode& take) { give_wall_corners(mesh, static_cast<int>(wall), take); });
    }
  }
  return uses.all();
}

}  // namespace etendue
