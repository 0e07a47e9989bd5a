// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/parents/foam_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <span>

#include "app/case/temperatures.h"
#include "app/write/parents/parent_means.h"
#include "base/position.h"
#include "solver/solution/flux_divergence.h"

namespace etendue {
namespace {

constexpr std::string_view divergence_dimensions = "[1 -1 -3 0 0 0 0]";  // W/m^3
constexpr std::string_view flux_dimensions = "[1 0 -3 0 0 0 0]";         // W/m^2

/// A patch of such a type has a field of this type.
bool is_constraint(const std::string& type) {
  constexpr std::array<std::string_view, 6> constraints = {
      "empty", "symmetry", "wedge", "processor", "cyclic", "nonuniformTransformCyclic"};
  return std::ranges::any_of(constraints, [&](std::string_view name) { return type.starts_with(name); });
}

std::string foam_list(std::span<const double> values) {
  std::string text = fmt::format("nonuniform List<scalar>\n{}\n(\n", values.size());
  for (const double value : values) fmt::format_to(std::back_inserter(text), "{}\n", value);
  return text + ")\n";
}

/// [wall] the values of its faces.
std::vector<std::vector<double>> values_of_patches(const PolyhedralMesh& mesh,
                                                   const std::vector<double>& of_faces) {
  std::vector<std::vector<double>> values(mesh.wall_names.size());
  for (std::size_t f = 0; f < of_faces.size(); ++f)
    if (mesh.face_walls[f] >= 0) values[position(mesh.face_walls[f])].push_back(of_faces[f]);
  return values;
}

std::string foam_field(const PolyhedralMesh& mesh, const std::string& name, std::string_view dimensions,
                       const std::string& inside, const std::function<std::string(std::size_t)>& on_patch) {
  std::string text = fmt::format(
      "FoamFile\n{{\n    version     2.0;\n    format      ascii;\n    class       volScalarField;\n"
      "    object      {};\n}}\n\ndimensions      {};\n\ninternalField   {};\n\nboundaryField\n{{\n",
      name, dimensions, inside);
  for (std::size_t w = 0; w < mesh.wall_names.size(); ++w) {
    text += fmt::format("    {}\n    {{\n", mesh.wall_names[w]);
    if (is_constraint(mesh.patch_types[w]))
      text += fmt::format("        type            {};\n    }}\n", mesh.patch_types[w]);
    else
      text += fmt::format("        type            calculated;\n        value           {};\n    }}\n",
                          on_patch(w));
  }
  return text + "}\n";
}

}  // namespace

std::vector<FoamFieldFile> foam_fields(const RunResult& result) {
  const TetrahedralMesh& mesh = result.problem.mesh();
  const PolyhedralMesh* parents = mesh.parents().mesh.get();
  if (parents == nullptr || parents->patch_types.empty() || !has_temperatures(result.input) ||
      !emits_isotropically(result.problem))
    return {};
  const std::vector<double> divergence =
      parent_means(mesh, flux_divergence(result.problem, result.solution), 1);
  const std::vector<std::vector<double>> fluxes = values_of_patches(*parents, parent_heat_flux(result));
  return {{"divergence", foam_field(*parents, "divergence", divergence_dimensions, foam_list(divergence),
                                    [](std::size_t) { return "uniform 0"; })},
          {"qr", foam_field(*parents, "qr", flux_dimensions, "uniform 0",
                            [&](std::size_t wall) { return foam_list(fluxes[wall]); })}};
}

}  // namespace etendue
