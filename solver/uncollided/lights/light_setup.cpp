// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/lights/light_setup.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <numbers>

#include "mesh/tetrahedra/corners.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/projection/light_at_wall.h"
#include "solver/uncollided/sources/beam_source.h"
#include "solver/uncollided/sources/extended_source.h"
#include "solver/uncollided/sources/point_source.h"
#include "solver/uncollided/sources/sky_source.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Part of the volume or of the boundary below which an emission is a light unless it says otherwise.
constexpr double small_part = 0.05;

/// Part of a light that may end at a wall that refracts: what it reflects or lets out is left out.
constexpr double most_at_refraction = 1e-6;

/// Walls that refract and that a light meets from within, and the part of its power that arrives there.
struct Meeting {
  std::vector<std::string> walls;
  double part = 0;
};

std::string text_of(const Meeting& met, const std::string& light) {
  const bool alone = met.walls.size() == 1;
  return fmt::format(
      "the light {} meets the {} {}, which {}, from within with {:.2g} of its power (light along rays ends "
      "at "
      "such a wall in this version, which may take {:g} of it); use uncollided = false, or solve.method = "
      "\"photons\"",
      light, alone ? "wall" : "walls", fmt::join(met.walls, ", "), alone ? "refracts" : "refract", met.part,
      most_at_refraction);
}

std::vector<double> values_of_cell(const Problem& problem, CellIndex cell,
                                   double (Problem::*value)(CellIndex, int) const) {
  std::vector<double> values;
  for (int b = 0; b < problem.band_count(); ++b) values.push_back((problem.*value)(cell, b));
  return values;
}

bool any_positive(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v > 0; });
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

EmitterPart part_of_cell(const Problem& problem, const LightPaths& paths, CellIndex cell) {
  EmitterPart part;
  part.cell = cell;
  std::ranges::copy(corners_of(problem.mesh(), cell), part.corners.begin());
  part.brightness = values_of_cell(problem, cell, &Problem::emission);
  for (std::size_t b = 0; b < part.brightness.size(); ++b)
    part.extinction.push_back(paths.extinction(cell, b));
  return part;
}

// Corners counterclockwise as seen from inside.
EmitterPart part_of_face(const Problem& problem, FaceIndex face) {
  const TetrahedralMesh& mesh = problem.mesh();
  EmitterPart part;
  std::ranges::copy(corners_of(mesh, face), part.corners.begin());
  const Vec3 normal = (part.corners[1] - part.corners[0]).cross(part.corners[2] - part.corners[0]);
  if (normal.dot(mesh.area_normal(face)) > 0) std::swap(part.corners[1], part.corners[2]);
  part.brightness = problem.wall(mesh.wall(face)).radiance;
  return part;
}

std::vector<EmitterPart> parts_of(const SurfaceLight& light) {
  std::vector<EmitterPart> parts;
  for (std::size_t i = 0; i + 2 < light.triangles.size(); i += 3)
    parts.push_back(
        {{light.triangles[i], light.triangles[i + 1], light.triangles[i + 2]}, light.radiance, {}});
  return parts;
}

}  // namespace

LightSetup::LightSetup(const Problem& problem, std::vector<double> added)
    : problem_(problem),
      paths_(problem, std::move(added)),
      region_is_light_(problem.media().size(), 0),
      wall_is_light_(problem.walls().size(), 0) {
  if (problem.space() == AngularSpace::plane) {
    refuse_all("in flatland", "a set on the sphere");
    return;
  }
  for (int region = 0; region < static_cast<int>(problem.media().size()); ++region)
    if (const std::string reason = reason_unseen(problem, region); !reason.empty()) {
      refuse_all("beside " + reason, "uncollided = \"auto\" or false, leaves, flakes or another formula");
      return;
    }
  refracting_ =
      std::ranges::any_of(problem.walls(), [](const Wall& wall) { return wall.refractive_index != 1; });
  add_lights();
  add_regions();
  add_walls();
  if (!sources_.empty()) shadow_edges_ = shadow_edges_of(paths_);
  check_refraction();
}

void LightSetup::check_refraction() {
  std::map<std::size_t, Meeting> refused;
  // The beams of a fibre follow each other.
  const auto continues_fibre = [&](std::size_t i) {
    return sources_[i]->name() == sources_[i - 1]->name() && sources_[i]->as_beam() != nullptr &&
           sources_[i]->as_beam()->has_profile();
  };
  for (const Wall& wall : problem_.walls()) {
    if (wall.refractive_index == 1) continue;
    for (std::size_t i = 0, next = 0; i < sources_.size(); i = next) {
      double power = 0, at_wall = 0;
      for (next = i; next == i || (next < sources_.size() && continues_fibre(next)); ++next) {
        const LightSource& source = *sources_[next];
        const double sent = std::accumulate(source.power().begin(), source.power().end(), 0.0);
        power += sent;
        at_wall += sent * part_at_wall(paths_, shadow_edges_, source, wall);
      }
      const double part = power > 0 ? at_wall / power : 0;
      if (part > most_at_refraction) {
        refused[i].walls.push_back(wall.name);
        refused[i].part += part;
      } else if (part > 0) {
        notes_.push_back(fmt::format(
            "light {}: {:.2g} of its power reaches the wall {}, which refracts, from within before "
            "its first collision, and ends there (its reflection is left out)",
            sources_[i]->name(), part, wall.name));
      }
    }
  }
  std::vector<Fault> faults;
  for (const auto& [source, met] : refused)
    faults.push_back(fault_at(origins_[source], "", text_of(met, sources_[source]->name())));
  if (!faults.empty()) throw InputError(std::move(faults));
}

void LightSetup::refuse_all(const std::string& where, const std::string& instead) {
  std::vector<Fault> faults;
  const auto refuse = [&](const Origin& origin, const std::string& what) {
    faults.push_back(fault_at(origin, "", what + " " + where + " (not in this version); use " + instead));
  };
  for (const Light& light : problem_.lights())
    if (light.uncollided != Uncollided::no || problem_.space() == AngularSpace::plane)
      refuse(light.origin, "a light");
  for (const Medium& medium : problem_.media())
    if (medium.uncollided == Uncollided::yes) refuse(medium.origin, "uncollided = true");
  for (const Wall& wall : problem_.walls())
    if (wall.uncollided == Uncollided::yes) refuse(wall.origin, "uncollided = true");
  if (!faults.empty()) throw InputError(std::move(faults));
}

void LightSetup::add_lights() {
  const auto lights = problem_.lights();
  if (lights.empty()) return;
  const CellLocator locator(problem_.mesh());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    if (continues_sky(lights, i)) continue;
    if (light.uncollided == Uncollided::no) {
      notes_.push_back(fmt::format("light {}: left to the directions (uncollided = false)", light.name));
      continue;
    }
    if (const auto* point = std::get_if<PointLight>(&light.kind)) {
      TangentCone cone(problem_.mesh(), locator.find(point->position));
      sources_.push_back(std::make_unique<PointSource>(light.name, *point, std::move(cone), paths_));
    } else if (i + 1 < lights.size() && continues_sky(lights, i + 1)) {
      std::vector<BeamLight> parts;
      for (std::size_t k = i; k == i || (k < lights.size() && continues_sky(lights, k)); ++k)
        parts.push_back(std::get<BeamLight>(lights[k].kind));
      sources_.push_back(std::make_unique<SkySource>(light.name, std::move(parts), paths_));
    } else if (const auto* beam = std::get_if<BeamLight>(&light.kind)) {
      if (beam->profile) paths_.mirrors().require_one_image_per_direction(beam->direction);
      sources_.push_back(std::make_unique<BeamSource>(light.name, *beam, paths_));
    } else {
      EmitterTree tree(EmitterShape::triangles, parts_of(std::get<SurfaceLight>(light.kind)));
      std::vector<double> power = scaled(tree.root().total, pi);
      sources_.push_back(
          std::make_unique<ExtendedSource>(light.name, std::move(power), std::move(tree), paths_));
    }
    origins_.push_back(light.origin);
    emitters_.push_back({Emitter::Kind::light, i});
    // A fibre has many beams.
    const std::string note = fmt::format("light {}: uncollided part exact", light.name);
    if (notes_.empty() || notes_.back() != note) notes_.push_back(note);
  }
}

bool LightSetup::chosen(Uncollided asked, double part, const std::string& what) {
  if (asked == Uncollided::no || (asked == Uncollided::automatic && part >= small_part)) return false;
  if (asked == Uncollided::automatic && refracting_) {
    notes_.push_back(fmt::format("{}: not a light (a wall refracts)", what));
    return false;
  }
  if (asked == Uncollided::automatic) {
    try {
      paths_.mirrors().images_of_point();
    } catch (const InputError&) {
      notes_.push_back(fmt::format("{}: not a light (mirrors are not at right angles)", what));
      return false;
    }
  }
  notes_.push_back(fmt::format(
      "{}: uncollided part exact ({})", what,
      asked == Uncollided::yes ? "uncollided = true" : fmt::format("{:.2g} % of the whole", 100 * part)));
  return true;
}

void LightSetup::add_regions() {
  const TetrahedralMesh& mesh = problem_.mesh();
  std::vector<std::vector<EmitterPart>> parts(problem_.media().size());
  std::vector<double> volume(parts.size(), 0);
  double whole = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const auto region = static_cast<std::size_t>(mesh.region(cell));
    volume[region] += mesh.volume(cell);
    whole += mesh.volume(cell);
    if (problem_.medium(mesh.region(cell)).uncollided == Uncollided::no) continue;
    EmitterPart part = part_of_cell(problem_, paths_, cell);
    if (any_positive(part.brightness)) parts[region].push_back(std::move(part));
  }
  for (std::size_t region = 0; region < parts.size(); ++region) {
    const Medium& medium = problem_.media()[region];
    if (parts[region].empty() || !chosen(medium.uncollided, volume[region] / whole, "region " + medium.name))
      continue;
    region_is_light_[region] = 1;
    EmitterTree tree(EmitterShape::tetrahedra, std::move(parts[region]));
    std::vector<double> power = scaled(tree.root().total, 4 * pi);
    sources_.push_back(
        std::make_unique<ExtendedSource>(medium.name, std::move(power), std::move(tree), paths_));
    origins_.push_back(medium.origin);
    emitters_.push_back({Emitter::Kind::region, region});
  }
}

void LightSetup::add_walls() {
  const TetrahedralMesh& mesh = problem_.mesh();
  std::vector<std::vector<EmitterPart>> parts(problem_.walls().size());
  std::vector<double> area(parts.size(), 0);
  double whole = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const auto wall = static_cast<std::size_t>(mesh.wall(face));
    area[wall] += mesh.area(face);
    whole += mesh.area(face);
    if (problem_.walls()[wall].uncollided != Uncollided::no && any_positive(problem_.walls()[wall].radiance))
      parts[wall].push_back(part_of_face(problem_, face));
  }
  for (std::size_t w = 0; w < parts.size(); ++w) {
    const Wall& wall = problem_.walls()[w];
    if (parts[w].empty() || !chosen(wall.uncollided, area[w] / whole, "wall " + wall.name)) continue;
    wall_is_light_[w] = 1;
    EmitterTree tree(EmitterShape::triangles, std::move(parts[w]));
    std::vector<double> power = scaled(tree.root().total, pi);
    sources_.push_back(
        std::make_unique<ExtendedSource>(wall.name, std::move(power), std::move(tree), paths_));
    origins_.push_back(wall.origin);
    emitters_.push_back({Emitter::Kind::wall, w});
  }
}

Problem LightSetup::remaining() const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  std::vector<Medium> media(problem_.media().begin(), problem_.media().end());
  std::vector<Wall> walls(problem_.walls().begin(), problem_.walls().end());
  for (std::size_t i = 0; i < media.size(); ++i)
    if (region_is_light_[i] != 0) {
      media[i].emission.assign(bands, Coefficient(0.0));
      media[i].blackbody.clear();
    }
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (wall_is_light_[i] != 0) walls[i].radiance.assign(bands, 0);
  std::vector<Light> swept;
  std::ranges::copy_if(problem_.lights(), std::back_inserter(swept),
                       [](const Light& light) { return light.uncollided == Uncollided::no; });
  Problem remaining(problem_.mesh(), problem_.bands(), std::move(media), std::move(walls), problem_.space(),
                    std::move(swept));
  if (!problem_.following().empty()) remaining.set_following(problem_.following());
  return remaining;
}

LightAtPoint LightSetup::at(const PointInCell& point, const std::optional<Vec3>& normal) const {
  const std::size_t bands = paths_.bands();
  LightAtPoint light{std::vector<double>(bands, 0), std::vector<Vec3>(bands, Vec3::Zero()), {}};
  if (normal) light.irradiance.assign(bands, 0);
  LightBeams beams(bands);
  LightDetail detail = fine_light;
  detail.shadow_edges = &shadow_edges_;
  for (const auto& source : sources_) {
    beams.clear();
    source->add_beams(point, Sight::attenuated, detail, beams);
    for (std::size_t i = 0; i < beams.size(); ++i)
      for (std::size_t b = 0; b < bands; ++b) {
        light.fluence[b] += beams.fluence(i)[b];
        light.net_flux[b] += beams.fluence(i)[b] * beams.direction(i);
        if (normal)
          light.irradiance[b] += beams.fluence(i)[b] * std::max(0.0, -normal->dot(beams.direction(i)));
      }
  }
  return light;
}

}  // namespace etendue
