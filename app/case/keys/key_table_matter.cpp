// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/key_table.h"
#include "solver/angular/harmonics/harmonics.h"
#include "solver/materials/kernels/directional_scattering.h"

namespace etendue {

using enum KeyType;
using namespace key_range;

namespace {

constexpr std::string_view legendre_help =
    "Of legendre: the moments chi_0 = 1, chi_1 = g, chi_2 …, without factors 2l + 1; or `file`.";
constexpr std::string_view phase_file_help =
    "CSV, found beside the case. Of legendre: one moment on each line. Of table: mu and p, from mu = -1 to "
    "1; p is "
    "linear between, and divided by its integral.";

constexpr std::string_view per_length = "1/length", per_volume = "power/(length^3 sr)";

KeyTable medium_keys() {
  KeyTable t("media.NAME");
  t.key("absorption", band_values, {.unit = per_length, .default_value = "0.0", .range = not_negative},
        "sigma_a; a formula may use the direction of travel wx, wy, wz too.");
  t.key("scattering", band_values, {.unit = per_length, .default_value = "0.0", .range = not_negative},
        "sigma_s, the integral of the kernel over outgoing directions.");
  t.key("reduced_scattering", band_values, {.unit = per_length, .range = not_negative},
        "sigma_s (1 - g), called mu_s' in tissue optics, instead of `scattering`; g is the mean cosine of "
        "`phase`, which has to be given.");
  t.key("extinction", band_values, {.unit = per_length, .range = not_negative},
        "sigma_a + sigma_s, instead of one of them or with `albedo`; alone it absorbs. A formula may use wx, "
        "wy, wz, where scattering or a kernel is given beside it or nothing scatters.");
  t.key("albedo", band_values, {.range = fraction}, "Scattering / extinction; needs `extinction`.");
  t.key("emission", band_values, {.unit = per_volume, .default_value = "0.0", .range = not_negative},
        "q; isotropic, unless a formula uses the direction of travel wx, wy, wz.");
  t.key("power_density", band_values, {.unit = "power/length^3", .range = not_negative},
        "4 pi emission (flatland: 2 pi), instead of it.");
  t.key(
      "power", band_numbers, {.unit = "power", .range = not_negative},
      "Of the whole region, instead of `emission`: divided by 4 pi (flatland: 2 pi) and the meshed volume.");
  t.key("temperature", place_value, {.unit = "K", .range = not_negative},
        "Instead of `emission`: the medium emits absorption times the radiance of a blackbody, divided among "
        "the bands by `bands.edges`, `bands.wsgg` or `bands.k_distribution` (docs/user/heat.md).");
  t.key("gas_pressure", place_value, {.unit = "atm", .range = not_negative},
        "Partial pressure of the gases that absorb together (of water vapour and carbon dioxide for "
        "`bands.wsgg`): those of `bands.wsgg` or `bands.k_distribution` absorb in proportion to it, besides "
        "`absorption`.");
  t.key("heat_source", place_value, {.unit = "W/m^3", .range = not_negative},
        "Instead of `temperature`: the medium sends out or conducts what it absorbs and this heat, and its "
        "temperature follows; 0: no heat but that of radiation.");
  t.key(
      "conductivity", thermal_value, {.unit = "W/(m K)", .range = not_negative},
      "Instead of `temperature`: the medium conducts heat, between walls at their `temperature` (others are "
      "insulated), and its temperature follows from conduction, radiation and `heat_source`. A formula may "
      "use the temperature T [K].");
  t.key("heat_capacity", thermal_value, {.unit = "J/(m^3 K)", .range = not_negative},
        "Density times specific heat, in a case with [time]: the medium stores heat, and its temperature "
        "changes with time. A formula may use the temperature T [K].");
  t.key("initial_temperature", place_value, {.unit = "K", .range = positive},
        "At t = 0, of a medium with `heat_capacity`. With `solve.initial` its temperatures come first.");
  t.key("scattering_method", band_texts,
        {.default_value = "\"auto\"", .choices = {"auto", "moments", "dense", "galerkin"}},
        "Through moments of the radiance, or a matrix between the directions: dense (never negative, exact "
        "energy and mean cosine) or galerkin. auto: moments where the phase function's series ends or "
        "`directions.first_collided` is given, else dense while the angular solution stays below 256 MiB; "
        "the reason is printed.");
  t.key("scattering_degree", integer,
        {.default_note = "chosen", .range = {.lowest = 0, .highest = highest_given_degree}},
        "Degree of the moments, where the choice by the phase function is not wanted; at most what the "
        "direction set resolves, which the log says.");
  t.key("forward_peak", band_texts, {.default_value = "\"auto\"", .choices = {"auto", "keep", "delta-m"}},
        "What the moments do with a peak that they do not resolve. delta-m, also called extended transport "
        "correction, counts it as not scattered. auto: delta-m where the part left out exceeds 0.02.");
  t.key(
      "kernel", any, {.unit = "1/(length sr)"},
      "Scattering from the direction (wx, wy, wz) into (vx, vy, vz) as a formula in these and x, y, z, "
      "instead of scattering and phase. A factor that depends on the place times one that depends on the "
      "directions takes one matrix; anything else a matrix in every cell, of its centroid. Or { file = "
      "\"k.csv\" }, lines of from, into, k with numbers of directions. Beside it absorption or extinction.");
  t.key("reciprocal", boolean, {.default_value = "false"},
        "Claims of the kernel that k(w, v) = k(-v, -w), which is checked.");
  t.key("refractive_index", number, {.default_note = "1", .range = positive},
        "By which light is slower here than in vacuum, in a case with [time]. It bends no rays. Where media "
        "have temperatures it is that of all of them: blackbodies send its square times as much into them.");
  t.key("in_time", text, {.default_note = "that of [time]"},
        "When the medium emits, in a case with [time]: see `time.in_time`. Where temperatures change with "
        "time: the part of `heat_source` at times t > 0, a formula in t or a CSV file.");
  t.key("uncollided", switch_, {.default_value = "\"auto\""},
        "Whether the emission's uncollided part is integrated along rays as that of a light; auto: where the "
        "region is below 5 % of the volume.");
  return t;
}

KeyTable field_keys() {
  KeyTable t(field_table);
  t.key("file", text, {.need = required},
        "VTK .vtu or .vti, NIfTI .nii or .nii.gz, or an OpenFOAM case: its folder or a .foam file.");
  t.key("array", text, {.default_note = "the only one"}, "Name of the array.");
  t.key("on", text, {.default_note = "cells, if they have it", .choices = {"cells", "points"}},
        "Which array is meant where both have one of this name.");
  t.key("component", integer, {.range = {.lowest = 0, .highest = largest_count}},
        "Of an array with several, from 0.");
  t.key("scale", number, {.default_value = "1.0"}, "Multiplies the values.");
  t.key("length_scale", number, {.default_value = "1.0", .range = positive},
        "Multiplies the coordinates of the file.");
  t.key("outside", number, {},
        "Value where the file's grid ends; without it the file must cover the region.");
  t.key("time", number, {.default_note = "the last"}, "Of OpenFOAM.");
  return t;
}

KeyTable leaf_keys() {
  KeyTable t("media.NAME.leaves");
  t.key("area_density", band_values, {.unit = per_length, .range = not_negative, .need = required},
        "Leaf area in a volume, one side counted.");
  t.key("angles", text, {.default_value = "\"spherical\"", .choices = leaf_angle_names()},
        "How the leaves' normals are inclined; z points up and azimuths are all alike.");
  t.key("reflectance", band_numbers, {.default_value = "0.0", .range = fraction}, "Of a leaf.");
  t.key("transmittance", band_numbers, {.default_value = "0.0", .range = fraction},
        "Of a leaf; reflectance + transmittance is at most 1.");
  return t;
}

KeyTable flake_keys() {
  KeyTable t("media.NAME.flakes");
  t.key("density", band_values, {.unit = per_length, .range = not_negative, .need = required},
        "Number in a volume times area.");
  t.key("axis", point, {.default_note = "[0, 0, 1]"}, "Of the ellipsoid of revolution.");
  t.key("along", number,
        {.default_value = "1.0", .range = {.lowest = 0, .highest = 1, .lowest_excluded = true}},
        "Projected area that light along the axis meets; below `across`: fibres.");
  t.key("across", number,
        {.default_value = "1.0", .range = {.lowest = 0, .highest = 1, .lowest_excluded = true}},
        "Projected area that light across the axis meets; below `along`: flakes that lie flat.");
  t.key("albedo", band_numbers, {.default_value = "0.0", .range = fraction}, "Of a flake, a mirror.");
  return t;
}

/// Of a phase function, and of a part of a mixture.
void add_mie_keys(KeyTable& t) {
  t.key("radius", number, {.range = positive},
        "Of mie: of the spheres; the median of a log-normal, the effective radius of a gamma distribution. "
        "In the unit of the wavelength.");
  t.key("index", number, {.range = positive},
        "Of mie: real part n of the refractive index relative to that outside.");
  t.key("absorption_index", number, {.default_value = "0.0", .range = not_negative},
        "Of mie: its imaginary part k, which absorbs.");
  t.key("wavelength", number, {.default_note = "the middle of the band's edges, nm", .range = positive},
        "Of mie: outside the spheres, in the unit of the radius.");
  t.key("distribution", text,
        {.default_value = "\"one-size\"", .choices = {"one-size", "log-normal", "gamma"}},
        "Of mie: how many spheres of which size.");
  t.key("deviation", number, {.range = {.lowest = 1, .highest = 10, .lowest_excluded = true}},
        "Of mie, log-normal: the geometric standard deviation.");
  t.key("variance", number,
        {.range = {.lowest = 0, .highest = 0.5, .lowest_excluded = true, .highest_excluded = true}},
        "Of mie, gamma: the effective variance.");
}

KeyTable phase_keys() {
  KeyTable t("media.NAME.phase");
  t.key("model", text,
        {.choices = {"isotropic", "rayleigh", "henyey-greenstein", "double-henyey-greenstein",
                     "cornette-shanks", "legendre", "table", "mie", "mixture"},
         .need = required},
        "The phase function.");
  t.key(
      "g", number, {.range = asymmetry},
      "Of henyey-greenstein: the mean cosine of the angle of deflection; of cornette-shanks: its parameter.");
  t.key("g1", number, {.range = asymmetry}, "Of double-henyey-greenstein.");
  t.key("g2", number, {.range = asymmetry}, "Of double-henyey-greenstein.");
  t.key("weight", number, {.range = fraction}, "Of g1 in double-henyey-greenstein; g2 has the rest.");
  t.key("coefficients", numbers, {}, legendre_help);
  t.key("file", text, {}, phase_file_help);
  add_mie_keys(t);
  return t;
}

KeyTable mix_keys() {
  KeyTable t("media.NAME.phase.mix");
  t.key("weight", number, {.range = positive, .need = required},
        "Its share of the scattering coefficient; shares are divided by their sum.");
  t.key("model", text,
        {.choices = {"isotropic", "rayleigh", "henyey-greenstein", "cornette-shanks", "legendre", "table",
                     "mie"},
         .need = required},
        "The phase function of this part.");
  t.key("g", number, {.range = asymmetry}, "As in `phase`.");
  t.key("coefficients", numbers, {}, "As in `phase`.");
  t.key("file", text, {}, "As in `phase`.");
  add_mie_keys(t);
  return t;
}

}  // namespace

std::vector<KeyDeclaration> matter_keys() {
  return declarations_of({medium_keys(), field_keys(), leaf_keys(), flake_keys(), phase_keys(), mix_keys()});
}

}  // namespace etendue
