// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_matter.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "app/case/read/lights/read_light.h"
#include "app/case/read/materials/read_directional.h"
#include "app/case/read/materials/read_gas_pressure.h"
#include "app/case/read/materials/read_glazing.h"
#include "app/case/read/materials/read_glossy.h"
#include "app/case/read/materials/read_heat_balance.h"
#include "app/case/read/materials/read_phase.h"
#include "app/case/read/materials/read_reduced_scattering.h"
#include "app/case/read/materials/read_temperature.h"
#include "app/case/values/band_values.h"
#include "app/case/values/in_time_value.h"
#include "app/case/values/medium_coefficients.h"
#include "solver/materials/media/angular_formula.h"

namespace etendue {
namespace {

// What a person computed with a few digits may exceed 1 by its rounding.
constexpr double reflectance_rounding = 1e-12;
// Of the integrals that the albedo of a glossy surface is known by.
constexpr double albedo_error = 1e-6;

std::string band_prefix(const Bands& bands, int band) {
  return bands.count() == 1 ? "" : "band " + bands.names[static_cast<std::size_t>(band)] + ": ";
}

bool gives_scattering(const Section& section) {
  return section.has("scattering") || section.has("reduced_scattering") || section.has("albedo") ||
         (section.has("extinction") && section.has("absorption"));
}

/// One function for each band from a table that depends on the wavelength; the first faulty band is reported.
std::vector<PhaseFunction> phases_of_bands(Section& section, const MatterContext& context,
                                           std::vector<std::string>& notes) {
  std::vector<PhaseFunction> phases;
  const std::size_t before = section.faults().size();
  for (int band = 0; band < std::max(context.bands.count(), 1); ++band) {
    phases.push_back(read_phase(section.section("phase"),
                                {context.space, context.case_folder, context.bands, band, &notes}));
    if (section.faults().size() > before) return {PhaseIsotropic{}};
  }
  return phases;
}

std::vector<PhaseFunction> read_phases(Section& section, const MatterContext& context,
                                       std::vector<std::string>& notes) {
  if (!gives_scattering(section)) {
    section.unused("phase", "nothing scatters in this region");
    return {PhaseIsotropic{}};
  }
  const TomlNode* node = section.find("phase");
  if (node == nullptr) return {PhaseIsotropic{}};
  if (node->is_table() && depends_on_band(section.section("phase")))
    return phases_of_bands(section, context, notes);
  const auto in_band = [&](int band) {
    return PhaseContext{context.space, context.case_folder, context.bands, band, &notes};
  };
  if (node->is_table()) return {read_phase(section.section("phase"), in_band(0))};
  check_band_count(section, "phase", node->array().size(), context.bands);
  std::vector<PhaseFunction> phases;
  for (Section& phase : section.list("phase")) {
    const int band = static_cast<int>(phases.size());
    phases.push_back(read_phase(std::move(phase), in_band(band)));
  }
  return phases;
}

// One text for each band.
std::vector<std::string> read_band_texts(Section& section, std::string_view name, const Bands& bands) {
  const TomlNode& node = section.value(name);
  std::vector<std::string> texts(static_cast<std::size_t>(bands.count()), "auto");
  if (node.faulty) return texts;
  if (!node.is_array()) return std::vector<std::string>(texts.size(), node.text());
  if (!check_band_count(section, name, node.array().size(), bands)) return texts;
  for (std::size_t band = 0; band < texts.size(); ++band) texts[band] = node.array()[band]->text();
  return texts;
}

ScatteringBackend backend_of(const std::string& method) {
  return method == "moments"    ? ScatteringBackend::moments
         : method == "dense"    ? ScatteringBackend::dense
         : method == "galerkin" ? ScatteringBackend::galerkin
                                : ScatteringBackend::automatic;
}

ForwardPeak peak_of(const std::string& text) {
  return text == "keep"      ? ForwardPeak::keep
         : text == "delta-m" ? ForwardPeak::delta_m
                             : ForwardPeak::automatic;
}

std::vector<ScatteringChoice> read_choices(Section& section, const Bands& bands) {
  if (!gives_scattering(section)) {
    for (const char* name : {"scattering_method", "scattering_degree", "forward_peak"})
      section.unused(name, "nothing scatters in this region");
    return {};
  }
  std::vector<ScatteringChoice> choices;
  const std::vector<std::string> methods = read_band_texts(section, "scattering_method", bands);
  const std::vector<std::string> peaks = read_band_texts(section, "forward_peak", bands);
  const TomlNode* degree = section.find("scattering_degree");
  bool by_moments = false;
  for (std::size_t band = 0; band < methods.size(); ++band) {
    choices.push_back({backend_of(methods[band]), -1, peak_of(peaks[band])});
    by_moments = by_moments || choices.back().backend == ScatteringBackend::moments ||
                 choices.back().backend == ScatteringBackend::automatic;
    if (degree != nullptr) choices.back().degree = static_cast<int>(degree->number());
  }
  if (!by_moments) section.unused("scattering_degree", "a matrix has no degree");
  return choices;
}

// Only values that are all sound can be compared.
bool any_faulty(const Section& section, std::initializer_list<const char*> names) {
  return std::ranges::any_of(names, [&](const char* name) {
    const TomlNode* node = section.node().find(name);
    return node != nullptr && node->faulty;
  });
}

template <class Problem>
void report_first(Section& section, const MediumCase& medium, const Bands& bands, Problem problem_of) {
  for (int band = 0; band < bands.count(); ++band)
    if (const std::string problem = problem_of(medium, band); !problem.empty())
      return section.fault(band_prefix(bands, band) + problem);
}

void check_medium(Section& section, const MediumCase& medium, const Bands& bands) {
  if (!any_faulty(section, {"extinction", "albedo", "absorption", "scattering"}))
    report_first(section, medium, bands, matter_problem);
  if (!any_faulty(section, {"emission", "power_density", "power"}))
    report_first(section, medium, bands, emission_problem);
}

bool is_by_direction(const Value& value) {
  const auto* formula = std::get_if<Formula>(&value);
  return formula != nullptr && depends_on_direction(*formula);
}

// Absorption may depend on the direction of travel; scattering that does is a kernel's.
void check_directions(Section& section, const MediumCase& medium, const Bands& bands) {
  if (any_faulty(section, {"extinction", "albedo", "absorption", "scattering"})) return;
  for (int band = 0; band < bands.count(); ++band) {
    const MatterValues values = matter_values(medium, band);
    if (is_by_direction(values.scattering))
      return section.fault(
          band_prefix(bands, band) +
          "scattering would depend on the direction (it follows from the extinction or absorption); give "
          "scattering, or a kernel");
    if (is_by_direction(values.absorption) && !medium.choice.empty() &&
        medium.choice[static_cast<std::size_t>(band)].backend == ScatteringBackend::moments)
      return section.fault("scattering_method",
                           "not where absorption depends on the direction (moments do not know it); use "
                           "\"auto\", \"dense\" or \"galerkin\"");
  }
}

// Rays carry numbers, the same in all directions.
void check_uncollided(Section& section, Uncollided asked, bool by_formula) {
  if (asked == Uncollided::yes && by_formula)
    section.fault("uncollided",
                  "not for emission that depends on the direction, nor for radiance by a formula, as that of "
                  "a hot wall is "
                  "where bands.molar_ratio is one (not in this version); use \"auto\" or false");
}

// Writes what an absent key means into the resolved case.
void fill_in(Section& section, const MediumCase& medium) {
  if (!medium.extinction && !medium.albedo)
    for (const char* name : {"absorption", "scattering"})
      if (name != std::string_view("scattering") || !section.has("reduced_scattering")) section.value(name);
  if (!medium.power_density && !medium.power && !section.has("temperature") && !section.has("heat_source") &&
      !section.has("conductivity") && !section.has("heat_capacity"))
    section.value("emission");
  if (gives_scattering(section) && !section.has("phase"))
    section.section("phase").resolve("model", "isotropic");
  if (!gives_scattering(section)) return;
  for (const char* name : {"scattering_method", "forward_peak"}) section.value(name);
}

MediumCase read_medium(Section section, const MatterContext& context) {
  const Bands& bands = context.bands;
  MediumCase medium;
  medium.space = context.space;
  medium.origin = section.origin();
  medium.refractive_index = section.number_if("refractive_index").value_or(1);
  medium.in_time = read_in_time(section, context.case_folder);
  if (is_directional(section)) {
    medium.emission = read_band_values(section, "emission", bands, FormulaOf::place_and_direction);
    medium.power_density = read_band_values(section, "power_density", bands);
    medium.power = read_band_values(section, "power", bands);
    read_directional(section, context, medium);
    for (const char* key : {"temperature", "heat_source", "conductivity", "heat_capacity", "gas_pressure"})
      section.unused(key,
                     "not beside leaves, flakes or a kernel in this version (their absorption depends on the "
                     "direction); use emission");
    if (!any_faulty(section, {"emission", "power_density", "power"}))
      report_first(section, medium, bands, emission_problem);
    section.value("uncollided");
    if (!medium.power_density && !medium.power) section.value("emission");
    return medium;
  }
  section.unused("reciprocal", "there is no kernel");
  medium.extinction = read_band_values(section, "extinction", bands, FormulaOf::place_and_direction);
  medium.albedo = read_band_values(section, "albedo", bands);
  medium.absorption = read_band_values(section, "absorption", bands, FormulaOf::place_and_direction);
  medium.scattering = read_band_values(section, "scattering", bands);
  medium.emission = read_band_values(section, "emission", bands, FormulaOf::place_and_direction);
  medium.power_density = read_band_values(section, "power_density", bands);
  medium.power = read_band_values(section, "power", bands);
  medium.phase = read_phases(section, context, medium.phase_notes);
  if (auto scattering = read_reduced_scattering(section, bands, context.space, medium.phase))
    medium.scattering = std::move(scattering);
  medium.uncollided = read_uncollided(section);
  medium.choice = read_choices(section, bands);
  const ThermalContext thermal{bands, context.molar_ratio, context.units, context.space};
  medium.temperature = read_medium_temperature(section, thermal);
  read_gas_pressure(section, thermal, medium);
  check_medium(section, medium, bands);
  set_thermal_emission(section, thermal, medium);
  read_heat_source(section, thermal, medium);
  check_uncollided(section, medium.uncollided, depend_on_direction(medium.emission));
  check_directions(section, medium, bands);
  fill_in(section, medium);
  return medium;
}

void check_reflectances(Section& section, const WallCase& wall, const Bands& bands) {
  for (int band = 0; band < bands.count(); ++band) {
    const double diffuse = std::get<double>(value_of(wall.diffuse, band));
    const double specular = std::get<double>(value_of(wall.specular, band));
    const double transmittance = std::get<double>(value_of(wall.transmittance, band));
    const double even = diffuse + specular + transmittance;
    const auto b = static_cast<std::size_t>(band);
    if (b < wall.glossy.size() && wall.glossy[b] != nullptr) {
      const AlbedoTable& lobe = wall.glossy[b]->albedo();
      if (even + lobe.largest() <= 1 + albedo_error) continue;
      return section.fault(fmt::format(
          "{}glossy reflects {:.4g} of light at {:.3g} degrees to the normal, and diffuse + specular + "
          "transmittance = {} (more light would leave than arrives); use at most 1 together",
          band_prefix(bands, band), lobe.largest(), lobe.angle_of_largest(), even));
    }
    if (even <= 1 + reflectance_rounding) continue;
    return section.fault(
        fmt::format("{}diffuse + specular{} = {} (more light would leave than arrives); use "
                    "at most 1",
                    band_prefix(bands, band), transmittance > 0 ? " + transmittance" : "", even));
  }
}

WallCase read_wall(const std::string& name, Section section, const WallContext& context) {
  const Bands& bands = context.bands;
  WallCase wall;
  wall.origin = section.origin();
  // Of a wall whose emissivity is given the diffuse reflectance follows.
  if (section.has("diffuse") || !section.has("emissivity"))
    wall.diffuse = read_band_values_or_default(section, "diffuse", bands);
  else
    wall.diffuse.values = {0.0};
  wall.specular = read_band_values_or_default(section, "specular", bands);
  wall.transmittance = read_band_values_or_default(section, "transmittance", bands);
  if (section.has("glossy")) wall.glossy = read_glossy(section.section("glossy"), bands, context.case_folder);
  wall.refractive_index = section.number("refractive_index");
  if (section.has("radiance") ||
      !(section.has("temperature") || section.has("heat_flux") || section.has("convection")))
    wall.radiance = read_band_values_or_default(section, "radiance", bands, FormulaOf::place_and_direction);
  if (!any_faulty(section, {"diffuse", "specular", "transmittance"})) {
    read_thermal_wall(section, {bands, context.molar_ratio, context.units, context.space}, wall);
    read_wall_heat(section, {bands, context.molar_ratio, context.units, context.space},
                   context.beside_conductors, wall);
  }
  wall.uncollided = read_uncollided(section);
  check_uncollided(section, wall.uncollided,
                   std::ranges::any_of(wall.radiance.values, [](const Value& value) {
                     return std::holds_alternative<Formula>(value);
                   }));
  wall.beam = read_beam(section, name, bands);
  wall.in_time = read_in_time(section, context.case_folder);
  if (wall.beam) {
    wall.beam->uncollided = wall.uncollided;
    wall.beam->in_time = wall.in_time;
  }
  if (section.has("glazing")) {
    wall.glazing = read_glazing(section.section("glazing"), bands);
    check_glazed_wall(section, wall);
  }
  if (!any_faulty(section, {"diffuse", "specular", "transmittance"}))
    check_reflectances(section, wall, bands);
  return wall;
}

template <class Entry, class Reader>
std::map<std::string, Entry> read_entries(Section section, const Bands& bands, std::string_view kind,
                                          std::string_view example, Reader reader) {
  std::map<std::string, Entry> entries;
  for (auto& [name, table] : section.named()) entries.emplace(name, reader(name, std::move(table), bands));
  if (section.node().table().entries.empty() && !section.node().faulty)
    section.fault("no entry; add one for each " + std::string(kind) + ", or \"*\" for all" +
                  std::string(example));
  return entries;
}

}  // namespace

std::map<std::string, MediumCase> read_media(Section media, const MatterContext& context) {
  const auto reader = [&context](const std::string&, Section section, const Bands&) {
    return read_medium(std::move(section), context);
  };
  return read_entries<MediumCase>(std::move(media), context.bands, "region", "", reader);
}

std::map<std::string, WallCase> read_walls(Section walls, const WallContext& context) {
  const auto reader = [&context](const std::string& name, Section section, const Bands&) {
    return read_wall(name, std::move(section), context);
  };
  return read_entries<WallCase>(std::move(walls), context.bands, "wall",
                                ", as [walls.\"*\"] with diffuse = 0.5", reader);
}

}  // namespace etendue
