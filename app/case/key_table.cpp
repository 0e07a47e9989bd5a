// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "app/case/keys.h"
#include "solver/angle/direction_set.h"

namespace etendue {
namespace {

using enum KeyType;

constexpr double largest_count = 1e9;  // fits an int
constexpr Range positive{.lowest = 0, .lowest_excluded = true};
constexpr Range not_negative{.lowest = 0};
constexpr Range fraction{.lowest = 0, .highest = 1};
constexpr Range open_fraction{.lowest = 0, .highest = 1, .lowest_excluded = true, .highest_excluded = true};

constexpr Range asymmetry{.lowest = -1, .highest = 1, .lowest_excluded = true, .highest_excluded = true};

constexpr std::string_view legendre_help =
    "Of legendre: the moments chi_0 = 1, chi_1 = g, chi_2 …, without factors 2l + 1; or `file`.";
constexpr std::string_view phase_file_help =
    "CSV, found beside the case. Of legendre: one moment on each line. Of table: mu and p, from mu = -1 to "
    "1; p is "
    "linear between, and divided by its integral.";

// Direction sets that are documented and not made yet.
std::vector<std::string> later_direction_sets() {
  const std::vector<std::string> here = direction_set_names();
  std::vector<std::string> later = {"double-gauss", "level-symmetric", "lebedev", "thurgood", "flatland"};
  std::erase_if(later, [&](const std::string& name) { return std::ranges::count(here, name) > 0; });
  return later;
}

std::vector<TableDeclaration> make_tables() {
  using enum TableForm;
  constexpr auto later = Support::later;
  return {
      {.path = "", .help = "Above the first table."},
      {.path = "units", .help = "One consistent system of units; nothing is converted."},
      {.path = "mesh", .help = "The geometry: exactly one of `file`, `surface` or primitives."},
      {.path = "mesh.box",
       .form = list,
       .help = "An axis-aligned box. Later primitives overwrite earlier ones, boxes, spheres and cylinders "
               "alike."},
      {.path = "mesh.sphere", .form = list, .help = "A ball, made of facets."},
      {.path = "mesh.cylinder", .form = list, .help = "A straight round cylinder, made of facets."},
      {.path = "mesh.patch",
       .form = list,
       .help = "An axis-aligned rectangle on the outside that gets a wall name of its own."},
      {.path = "mesh.sheet", .form = table_or_list, .support = later, .help = "A surface inside the domain."},
      {.path = "bands", .help = "The spectral bands, solved side by side."},
      {.path = "media", .help = "Every region has an entry; \"*\" stands for the rest."},
      {.path = "media.NAME", .help = "The matter in the region NAME; an empty entry is a void."},
      {.path = "media.NAME.phase",
       .form = table_or_list,
       .help = "How light turns when it scatters: one table, or a list with one for each band; without it "
               "isotropic."},
      {.path = "media.NAME.phase.mix", .form = list, .help = "Of the model mixture: its parts."},
      {.path = "walls", .help = "Every wall has an entry; \"*\" stands for the rest."},
      {.path = "walls.NAME", .help = "What the wall NAME does; an empty entry is black and cold."},
      {.path = "walls.NAME.beam", .support = later, .help = "Collimated light that enters here."},
      {.path = "light", .form = list, .support = later, .help = "A light whose uncollided part is exact."},
      {.path = "directions", .help = "The directions in which light travels."},
      {.path = "space", .help = "The discretisation in space."},
      {.path = "solve", .help = "The iteration."},
      {.path = "exact",
       .help = "What the answer is: the source and what enters at the walls follow from it. Nothing else may "
               "emit, "
               "and walls are black."},
      {.path = "probe", .form = list, .help = "Points whose values go into `probes.csv`."},
      {.path = "probe.line", .help = "Points at equal distances instead of `points`."},
      {.path = "camera", .form = list, .support = later, .help = "A picture."},
      {.path = "sensor", .form = list, .support = later, .help = "A measured quantity."},
      {.path = "output", .help = "What is written, and where."},
  };
}

std::vector<KeyDeclaration> make_keys() {
  constexpr auto required = Need::required;
  constexpr auto later = Support::later;
  const std::string_view per_length = "1/length", per_volume = "power/(length^3 sr)";
  const Range sphere_facets{.lowest = 8, .highest = 1e6}, cylinder_facets{.lowest = 3, .highest = 1e5};
  return {
      {"", "title", text, {.default_value = "\"\"", .help = "What the case is called."}},

      {"units", "length", text, {.default_value = "\"m\"", .help = "m, cm, mm, km or any label."}},
      {"units", "power", text, {.default_value = "\"W\"", .help = "W, mW, \"1/s\" or any label."}},

      {"mesh", "file", text, {.help = "A tetrahedral mesh: Gmsh .msh, .vtu, TetGen .node/.ele/.face."}},
      {"mesh",
       "surface",
       text,
       {.help = "A closed surface to fill: TetGen .poly/.smesh, STL, OBJ, PLY, OFF."}},
      {"mesh",
       "max_volume",
       size_bound,
       {.unit = "length^3",
        .range = positive,
        .help = "Largest cell, for all regions or by region; \"*\" stands for the rest."}},
      {"mesh",
       "edge_length",
       size_bound,
       {.unit = "length",
        .range = positive,
        .help = "The same said as a length a: max_volume = a^3/(6 sqrt 2). One of the two."}},
      {"mesh",
       "quality",
       number,
       {.default_value = "1.4",
        .range = {.lowest = 1.1},
        .help = "Largest ratio of a cell's circumradius to its shortest edge."}},
      {"mesh",
       "scale",
       number,
       {.default_value = "1.0", .range = positive, .help = "Multiplies the coordinates read from a file."}},
      {"mesh",
       "regions",
       named_points,
       {.unit = "length",
        .help = "Of a surface: a point inside each region, after scaling; without it \"domain\"."}},

      {"mesh.box", "region", text, {.help = "Name of the region that fills it; not for a hole."}},
      {"mesh.box", "min", point, {.unit = "length", .need = required, .help = "Lowest corner."}},
      {"mesh.box", "max", point, {.unit = "length", .need = required, .help = "Highest corner."}},
      {"mesh.box",
       "walls",
       named_sides,
       {.help = "Wall names of the sides xmin … zmax that end up on the outside."}},
      {"mesh.box",
       "hole",
       boolean,
       {.default_value = "false",
        .help = "Removes the volume; its surface becomes walls NAME.xmin … NAME.zmax."}},
      {"mesh.box", "name", text, {.help = "Of a hole: what its walls' names begin with."}},

      {"mesh.sphere", "region", text, {.help = "Name of the region that fills it; not for a hole."}},
      {"mesh.sphere", "center", point, {.unit = "length", .need = required, .help = "Centre."}},
      {"mesh.sphere",
       "radius",
       number,
       {.unit = "length", .range = positive, .need = required, .help = "Radius."}},
      {"mesh.sphere",
       "facets",
       integer,
       {.default_value = "320", .range = sphere_facets, .help = "About how many triangles it is made of."}},
      {"mesh.sphere",
       "hole",
       boolean,
       {.default_value = "false", .help = "Removes the volume; its surface becomes the wall NAME."}},
      {"mesh.sphere", "name", text, {.help = "Of a hole: its wall's name."}},

      {"mesh.cylinder", "region", text, {.help = "Name of the region that fills it; not for a hole."}},
      {"mesh.cylinder", "from", point, {.unit = "length", .need = required, .help = "Middle of one end."}},
      {"mesh.cylinder",
       "to",
       point,
       {.unit = "length", .need = required, .help = "Middle of the other end."}},
      {"mesh.cylinder",
       "radius",
       number,
       {.unit = "length", .range = positive, .need = required, .help = "Radius."}},
      {"mesh.cylinder",
       "facets",
       integer,
       {.default_value = "32", .range = cylinder_facets, .help = "How many sides it has."}},
      {"mesh.cylinder",
       "hole",
       boolean,
       {.default_value = "false", .help = "Removes the volume; its surface becomes the wall NAME."}},
      {"mesh.cylinder", "name", text, {.help = "Of a hole: its wall's name."}},

      {"mesh.patch", "wall", text, {.need = required, .help = "Name of the wall."}},
      {"mesh.patch",
       "min",
       point,
       {.unit = "length", .need = required, .help = "Lowest corner; agrees with `max` in one coordinate."}},
      {"mesh.patch", "max", point, {.unit = "length", .need = required, .help = "Highest corner."}},

      {"bands", "names", texts, {.default_value = "[\"grey\"]", .help = "One name for each band."}},
      {"bands",
       "edges",
       numbers,
       {.unit = "nm",
        .range = positive,
        .help = "Wavelengths between the bands, rising or falling; one more than names."}},

      {"media.NAME",
       "absorption",
       band_values,
       {.unit = per_length, .default_value = "0.0", .range = not_negative, .help = "sigma_a."}},
      {"media.NAME",
       "scattering",
       band_values,
       {.unit = per_length,
        .default_value = "0.0",
        .range = not_negative,
        .help = "sigma_s, the integral of the kernel over outgoing directions."}},
      {"media.NAME",
       "extinction",
       band_values,
       {.unit = per_length,
        .range = not_negative,
        .help = "sigma_a + sigma_s, instead of one of them or with `albedo`; alone it absorbs."}},
      {"media.NAME",
       "albedo",
       band_values,
       {.range = fraction, .help = "Scattering / extinction; needs `extinction`."}},
      {"media.NAME",
       "emission",
       band_values,
       {.unit = per_volume, .default_value = "0.0", .range = not_negative, .help = "q, isotropic."}},
      {"media.NAME",
       "power_density",
       band_values,
       {.unit = "power/length^3",
        .range = not_negative,
        .help = "4 pi emission (flatland: 2 pi), instead of it."}},
      {"media.NAME",
       "power",
       band_numbers,
       {.unit = "power",
        .range = not_negative,
        .help = "Of the whole region, instead of `emission`: divided by 4 pi (flatland: 2 pi) and the meshed "
                "volume."}},
      {"media.NAME", "kernel", any, {.support = later, .help = "A general scattering kernel."}},
      {"media.NAME",
       "uncollided",
       switch_,
       {.default_value = "\"auto\"",
        .later = {"true"},
        .help = "Whether the emission's uncollided part is treated as a light."}},

      {"media.NAME.phase",
       "model",
       text,
       {.choices = {"isotropic", "rayleigh", "henyey-greenstein", "double-henyey-greenstein",
                    "cornette-shanks", "legendre", "table", "mixture"},
        .need = required,
        .help = "The phase function."}},
      {"media.NAME.phase",
       "g",
       number,
       {.range = asymmetry,
        .help = "Of henyey-greenstein: the mean cosine of the angle of deflection; of cornette-shanks: its "
                "parameter."}},
      {"media.NAME.phase", "g1", number, {.range = asymmetry, .help = "Of double-henyey-greenstein."}},
      {"media.NAME.phase", "g2", number, {.range = asymmetry, .help = "Of double-henyey-greenstein."}},
      {"media.NAME.phase",
       "weight",
       number,
       {.range = fraction, .help = "Of g1 in double-henyey-greenstein; g2 has the rest."}},
      {"media.NAME.phase", "coefficients", numbers, {.help = legendre_help}},
      {"media.NAME.phase", "file", text, {.help = phase_file_help}},
      {"media.NAME.phase.mix",
       "weight",
       number,
       {.range = positive,
        .need = required,
        .help = "Its share of the scattering coefficient; shares are divided by their sum."}},
      {"media.NAME.phase.mix",
       "model",
       text,
       {.choices = {"isotropic", "rayleigh", "henyey-greenstein", "cornette-shanks", "legendre", "table"},
        .need = required,
        .help = "The phase function of this part."}},
      {"media.NAME.phase.mix", "g", number, {.range = asymmetry, .help = "As in `phase`."}},
      {"media.NAME.phase.mix", "coefficients", numbers, {.help = "As in `phase`."}},
      {"media.NAME.phase.mix", "file", text, {.help = "As in `phase`."}},

      {"walls.NAME",
       "diffuse",
       band_numbers,
       {.default_value = "0.0",
        .range = fraction,
        .help = "Lambertian reflectance; diffuse + specular is at most 1."}},
      {"walls.NAME",
       "specular",
       band_numbers,
       {.default_value = "0.0", .range = fraction, .help = "Mirror reflectance."}},
      {"walls.NAME",
       "radiance",
       band_numbers,
       {.unit = "power/(length^2 sr)",
        .default_value = "0.0",
        .range = not_negative,
        .later = {"a formula"},
        .help = "Radiance that the wall sends into the domain, isotropic."}},
      {"walls.NAME",
       "uncollided",
       switch_,
       {.default_value = "\"auto\"",
        .later = {"true"},
        .help = "Whether the radiance's uncollided part is treated as a light."}},

      {"directions",
       "set",
       text,
       {.default_value = "\"ldfe-sq\"",
        .choices = direction_set_names(),
        .later = later_direction_sets(),
        .help = "`etendue directions` lists the sets and their sizes."}},
      {"directions",
       "order",
       integer,
       {.default_value = "1",
        .range = {.lowest = 1, .highest = 1e4},
        .help = "What it means depends on the set."}},
      {"directions",
       "rotation",
       rotation,
       {.unit = "degrees",
        .help =
            "Turns the set about an axis, or at random; a mirror must still take ordinates to ordinates."}},
      {"directions",
       "seed",
       integer,
       {.default_value = "1",
        .range = {.lowest = 0, .highest = largest_count},
        .help = "Chooses the random rotation."}},

      {"space",
       "order",
       integer,
       {.default_value = "1",
        .choices = {"0", "1"},
        .later = {"2", "3"},
        .help = "Polynomial degree of the discontinuous Galerkin space."}},
      {"space",
       "lumping",
       text,
       {.default_value = "\"auto\"",
        .choices = {"none", "mass", "auto"},
        .help = "Of the mass; auto: where extinction times cell size exceeds 2."}},
      {"space",
       "positivity",
       text,
       {.default_value = "\"none\"",
        .choices = {"none", "rescale", "quadratic"},
        .help = "Takes negative radiance out of every cell after the linear solution: to zero with the rest "
                "rescaled, or by the nearest values that balance."}},

      {"solve",
       "method",
       text,
       {.default_value = "\"auto\"",
        .choices = {"auto", "gmres", "source-iteration"},
        .later = {"radiosity", "photons"},
        .help = "auto: the best that this version has, which is gmres."}},
      {"solve",
       "acceleration",
       text,
       {.default_value = "\"auto\"",
        .choices = {"auto", "diffusion", "none"},
        .help = "Of the iteration. auto: diffusion with gmres and space.order = 1."}},
      {"solve",
       "tolerance",
       number,
       {.default_value = "1e-6",
        .range = open_fraction,
        .help = "Estimated relative error of the iteration, per band."}},
      {"solve",
       "max_sweeps",
       integer,
       {.default_value = "500",
        .range = {.lowest = 1, .highest = largest_count},
        .help = "Every transport sweep counts."}},
      {"solve",
       "threads",
       integer,
       {.default_value = "0", .range = {.lowest = 0, .highest = 4096}, .help = "0: all cores."}},
      {"solve",
       "initial",
       text,
       {.help = "A `solution.vtu` of the same mesh and case to start from; what is solved and written may "
                "differ."}},

      {"exact",
       "radiance",
       text,
       {.unit = "power/(length^2 sr)",
        .need = required,
        .help = "A formula in x, y, z and the direction of travel wx, wy, wz; the same in all bands."}},

      {"probe", "name", text, {.need = required, .help = "Names the rows in `probes.csv`."}},
      {"probe", "points", points, {.unit = "length", .help = "Where; or `line`."}},
      {"probe",
       "normal",
       point,
       {.help = "Also the irradiance of light that falls on the side it points to; of any length."}},
      {"probe.line", "from", point, {.unit = "length", .need = required, .help = "First point."}},
      {"probe.line", "to", point, {.unit = "length", .need = required, .help = "Last point."}},
      {"probe.line",
       "count",
       integer,
       {.range = {.lowest = 2, .highest = 1e7}, .need = required, .help = "How many points."}},

      {"output",
       "directory",
       text,
       {.default_note = "the case's name, in the working directory",
        .help = "Made with its parents; an earlier result there is replaced."}},
      {"output",
       "fields",
       texts,
       {.default_value = "[\"fluence\", \"net_flux\"]",
        .help = "\"fluence\", \"net_flux\", \"media\", \"radiance:K\" for the ordinate K (from 0)."}},
      {"output",
       "checkpoint_every",
       integer,
       {.default_value = "0",
        .range = {.lowest = 0, .highest = largest_count},
        .help = "Sweeps after which `solution.vtu` is written while the run goes on; 0: only at its end."}},
  };
}

}  // namespace

std::span<const KeyDeclaration> key_declarations() {
  static const std::vector<KeyDeclaration> keys = make_keys();
  return keys;
}

std::span<const TableDeclaration> table_declarations() {
  static const std::vector<TableDeclaration> tables = make_tables();
  return tables;
}

}  // namespace etendue
