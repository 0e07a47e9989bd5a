// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/problem_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/tetrahedra/sheet_faces.h"

namespace etendue {
namespace {

// Reflectances like 0.7 and 0.3 may miss 1 by rounding.
constexpr double rounding = 1e-12;

Origin with_key(const Origin& origin, const std::string& table, const std::string& name,
                const std::string& what) {
  const std::string owner = origin.key.empty() ? table + "." + name : origin.key;
  return {origin.file, origin.line, owner + "." + what};
}

std::string shown(double value) { return fmt::format("{:.6g}", value); }

bool reflects_fully(const Wall& wall, std::size_t band) {
  return wall.mean_reflectance(band) + wall.transmitted(band) >= 1 - rounding;
}

/// Of the integrals that the albedo of a glossy surface is known by.
constexpr double albedo_error = 1e-6;

/// One number of a wall that must lie in [0, most].
void check_range(const Wall& wall, const std::string& what, double value, double most,
                 const std::string& band, std::vector<Fault>& faults) {
  if (value >= 0 && value <= most && std::isfinite(value)) return;
  const std::string range = std::isinf(most) ? "a finite number of at least 0" : "a number from 0 to 1";
  faults.push_back(fault_at(origin_of(wall, what), shown(value),
                            fmt::format("out of range (band {}); give {}", band, range)));
}

bool is_given(const std::vector<std::optional<AngularFormula>>& formulas, std::size_t band) {
  return band < formulas.size() && formulas[band];
}

/// Where what emits in this band came from: the first such medium, else the first such wall; empty if
/// nothing does.
std::optional<Origin> emitter(const Problem& problem, std::size_t band) {
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<bool> emits(problem.media().size(), false);
  for (int c = 0; c < mesh.cell_count(); ++c)
    if (problem.emission(CellIndex(c), static_cast<int>(band)) > 0)
      emits[static_cast<std::size_t>(mesh.region(CellIndex(c)))] = true;
  for (std::size_t region = 0; region < emits.size(); ++region)
    if (emits[region]) return origin_of(problem.media()[region], "emission");
  for (const Medium& medium : problem.media())
    if (is_given(medium.emission_by_direction, band)) return origin_of(medium, "emission");
  for (const Wall& wall : problem.walls())
    if (wall.radiance[band] > 0 || is_given(wall.radiance_by_direction, band))
      return origin_of(wall, "radiance");
  if (!problem.lights().empty()) return problem.lights().front().origin;
  return {};
}

bool anything_absorbs(const Problem& problem, std::size_t band) {
  for (int c = 0; c < problem.mesh().cell_count(); ++c)
    if (problem.absorption(CellIndex(c), static_cast<int>(band)) > 0) return true;
  return !std::all_of(problem.walls().begin(), problem.walls().end(),
                      [band](const Wall& wall) { return reflects_fully(wall, band); });
}

}  // namespace

Origin origin_of(const Medium& medium, const std::string& what) {
  return with_key(medium.origin, "media", medium.name, what);
}

Origin origin_of(const Wall& wall, const std::string& what) {
  return with_key(wall.origin, "walls", wall.name, what);
}

bool check_sample(const CoefficientPlace& place, const Coefficient& coefficient, const CellSample& sample,
                  std::vector<Fault>& faults) {
  if (sample.smallest >= 0 && std::isfinite(sample.smallest)) return true;
  const std::string where =
      coefficient.is_constant()
          ? ""
          : fmt::format(" at ({:.6g}, {:.6g}, {:.6g})", sample.where.x(), sample.where.y(), sample.where.z());
  const char* what =
      sample.smallest < 0 && std::isfinite(sample.smallest) ? "negative" : "not a finite number";
  faults.push_back(
      fault_at(place.origin, fmt::format("{:.6g}", sample.smallest),
               fmt::format("{}{} (band {}); must be a finite number of at least 0 in the whole region", what,
                           where, place.band)));
  return false;
}

void check_phase(const Medium& medium, const Bands& bands, std::vector<Fault>& faults) {
  for (std::size_t band = 0; band < bands.names.size(); ++band) {
    const double g = phase_asymmetry(medium.phase[band]);
    if (!(std::abs(g) < 1))
      faults.push_back(fault_at(
          origin_of(medium, "phase.g"), shown(g),
          fmt::format("no phase function (band {}); give a mean cosine between -1 and 1, both excluded",
                      bands.names[band])));
  }
}

void check_wall(const Wall& wall, const Bands& bands, std::vector<Fault>& faults) {
  for (std::size_t band = 0; band < bands.names.size(); ++band) {
    const std::string& name = bands.names[band];
    const std::size_t before = faults.size();
    check_range(wall, "radiance", wall.radiance[band], HUGE_VAL, name, faults);
    check_range(wall, "diffuse", wall.diffuse[band], 1, name, faults);
    check_range(wall, "specular", wall.specular[band], 1, name, faults);
    if (wall.refractive_index != 1 &&
        (wall.diffuse[band] > 0 || wall.specular[band] > 0 || wall.glossy_in(band) != nullptr ||
         wall.transmitted(band) > 0 || is_given(wall.radiance_by_direction, band)))
      faults.push_back(fault_at(
          origin_of(wall, "refractive_index"), shown(wall.refractive_index),
          fmt::format("with a reflectance or a formula for the radiance (band {}; what a smooth surface "
                      "reflects and lets in follows from the index); give one or the other",
                      name)));
    check_range(wall, "transmittance", wall.transmitted(band), 1, name, faults);
    const double even = wall.diffuse[band] + wall.specular[band] + wall.transmitted(band);
    const AlbedoTable lobe = wall.glossy_in(band) != nullptr ? wall.glossy_in(band)->albedo() : AlbedoTable();
    if (faults.size() > before || even + lobe.largest() <= 1 + (lobe.largest() > 0 ? albedo_error : rounding))
      continue;
    if (lobe.largest() > 0)
      faults.push_back(fault_at(
          origin_of(wall, "glossy"), shown(lobe.largest()),
          fmt::format(
              "of light at {:.3g} degrees to the normal this part is reflected, and {:.6g} otherwise: "
              "more light than arrives (band {}); give at most 1 together at every angle",
              lobe.angle_of_largest(), even, name)));
    else
      faults.push_back(fault_at(
          origin_of(wall, wall.transmits() ? "diffuse + specular + transmittance" : "diffuse + specular"),
          shown(even),
          fmt::format("reflects more light than arrives (band {}); give at most 1 together", name)));
  }
}

void check_sheets(const Problem& problem, std::vector<Fault>& faults) {
  const TetrahedralMesh& mesh = problem.mesh();
  if (std::ranges::none_of(problem.walls(), [](const Wall& wall) { return wall.transmits(); })) return;
  const std::vector<std::int32_t> behind = faces_behind(mesh);
  std::vector<char> told(problem.walls().size(), 0);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const int number = mesh.wall(FaceIndex(f));
    const Wall& wall = problem.wall(number);
    const std::int32_t other = behind[static_cast<std::size_t>(f)];
    if (told[static_cast<std::size_t>(number)] || !wall.transmits()) continue;
    std::string problem_text;
    if (other < 0) {
      const Vec3 at = mesh.centroid(FaceIndex(f));
      problem_text = fmt::format(
          "the wall is no sheet at ({:.6g}, {:.6g}, {:.6g}): nothing is behind it; give transmittance to the "
          "sides of a [[mesh.sheet]]",
          at.x(), at.y(), at.z());
    } else {
      const Wall& back = problem.wall(mesh.wall(FaceIndex(other)));
      for (std::size_t b = 0; b < wall.transmittance.size() && problem_text.empty(); ++b)
        if (std::abs(wall.transmitted(b) - back.transmitted(b)) > rounding)
          problem_text = fmt::format(
              "the other side of the sheet, {}, has {:.6g} (band {}; light goes both ways alike); give both "
              "the same",
              back.name, back.transmitted(b), problem.bands().names[b]);
    }
    if (problem_text.empty()) continue;
    told[static_cast<std::size_t>(number)] = 1;
    faults.push_back(fault_at(origin_of(wall, "transmittance"), shown(wall.transmitted(0)), problem_text));
  }
}

void check_steady_state(const Problem& problem, std::vector<Fault>& faults) {
  const Bands& bands = problem.bands();
  for (std::size_t band = 0; band < bands.names.size(); ++band) {
    if (anything_absorbs(problem, band)) continue;
    if (const std::optional<Origin> origin = emitter(problem, band))
      faults.push_back(fault_at(*origin, "",
                                fmt::format("no steady state in band {} (light is emitted, nothing absorbs "
                                            "and every wall reflects fully); give a medium absorption or a "
                                            "wall a reflectance below 1",
                                            bands.names[band])));
  }
}

}  // namespace etendue
