// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/key_table.h"

#include <iterator>

namespace etendue {
namespace {

std::vector<TableDeclaration> make_tables() {
  using enum TableForm;
  return {
      {.path = "", .help = "Above the first table."},
      {.path = "units", .help = "One consistent system of units; nothing is converted."},
      {.path = "mesh", .help = "The geometry: exactly one of `file`, `surface`, `labels` or primitives."},
      {.path = "mesh.labels",
       .help = "Voxels of an image that say which region each belongs to; the sides of the image become the "
               "walls xmin … zmax, and what borders on voxels without a region the wall surface."},
      {.path = "mesh.box",
       .form = list,
       .help = "An axis-aligned box. Later primitives overwrite earlier ones, boxes, spheres and cylinders "
               "alike."},
      {.path = "mesh.sphere", .form = list, .help = "A ball, made of facets."},
      {.path = "mesh.cylinder", .form = list, .help = "A straight round cylinder, made of facets."},
      {.path = "mesh.patch",
       .form = list,
       .help = "An axis-aligned rectangle on the outside that gets a wall name of its own."},
      {.path = "mesh.sheet",
       .form = list,
       .help = "An opaque plane sheet inside the domain, with a wall on each side; `corners`, or `min` and "
               "`max` of a rectangle."},
      {.path = "bands", .help = "The spectral bands, solved side by side."},
      {.path = "media", .help = "Every region has an entry; \"*\" stands for the rest."},
      {.path = "media.NAME", .help = "The medium in the region NAME; an empty entry is a void."},
      {.path = field_table,
       .help =
           "A value from a file, in the place of a number or formula: `absorption = { file = \"gas.vtu\", "
           "array = \"kappa\" }`; for every key of that type, radiance of walls too (docs/user/fields.md)."},
      {.path = "media.NAME.phase",
       .form = table_or_list,
       .help = "How light turns when it scatters: one table, or a list with one for each band; without it "
               "isotropic."},
      {.path = "media.NAME.leaves",
       .help = "A canopy of flat leaves (Ross), instead of absorption, scattering and phase."},
      {.path = "media.NAME.flakes",
       .help = "Micro-flakes (SGGX): mirrors much smaller than a cell, instead of absorption, scattering and "
               "phase."},
      {.path = "media.NAME.phase.mix", .form = list, .help = "Of the model mixture: its parts."},
      {.path = "walls", .help = "Every wall has an entry; \"*\" stands for the rest."},
      {.path = "walls.NAME", .help = "What the wall NAME does; an empty entry is black and cold."},
      {.path = "walls.NAME.glossy",
       .help = "A reflectance f_r beside the diffuse and the mirror one; of all together at most 1 is "
               "reflected at every angle."},
      {.path = "walls.NAME.convection",
       .help = "Heat that what flows along the wall carries away; the wall's temperature follows "
               "(docs/user/heat.md)."},
      {.path = "walls.NAME.glazing",
       .help = "Panes of clear or tinted glass in an outer, flat wall, by which the sun and the sky come in: "
               "Fresnel's reflection and absorption by the angle of incidence. Light that arrives there from "
               "inside leaves, but for what the wall reflects diffusely."},
      {.path = "walls.NAME.beam", .help = "Collimated light that enters here; the wall must not mirror."},
      {.path = "light",
       .form = list,
       .help = "A light whose uncollided part is integrated along rays. Which keys it takes depends on its "
               "kind (docs/user/lights.md)."},
      {.path = "light.sun_position",
       .help = "Where the sun of a sun or a sky stands, z being up: `altitude` and `azimuth`, or a date, "
               "time and place."},
      {.path = "directions", .help = "The directions in which light travels."},
      {.path = "directions.refine",
       .help = "Of ldfe-sq: finer directions in a cone, and in its opposite; mirrors must keep the cones."},
      {.path = "directions.first_collided",
       .help =
           "Light of lights that has collided once, or was reflected diffusely once, is swept once on a set "
           "of its own, finer than that of the rest: less of ray effects for the price of one sweep."},
      {.path = "space", .help = "The discretisation in space."},
      {.path = "solve", .help = "The iteration."},
      {.path = "photon_map",
       .help = "What the cameras of solve.method = \"photons\" see (docs/user/photons.md)."},
      {.path = "radiosity", .help = "Of solve.method = \"radiosity\" (docs/user/radiosity.md)."},
      {.path = "exact",
       .help = "What the answer is: the source and what enters at the walls follow from it. Nothing else may "
               "emit, "
               "and walls are black."},
      {.path = "accuracy",
       .help = "How accurate the numbers are to be: `run` refines cells and directions "
               "(docs/user/accuracy.md)."},
      {.path = "accuracy.budget", .help = "What the rounds may take."},
      {.path = "time",
       .help = "Light that changes with time, beside the steady one: at frequencies, at times "
               "(docs/user/time.md)."},
      {.path = "probe", .form = list, .help = "Points whose values go into `probes.csv`."},
      {.path = "probe.line", .help = "Points at equal distances instead of `points`."},
      {.path = "camera",
       .form = list,
       .help = "A picture: NAME.exr, linear, and NAME.png (docs/user/pictures.md)."},
      {.path = "camera.false_color",
       .help = "NAME.false.png: the picture in the colors of a scale (viridis), which is drawn beside it "
               "with its "
               "numbers and unit."},
      {.path = "sensor",
       .form = list,
       .help = "An instrument, anywhere in the domain or on a wall; its numbers go into `sensors.csv` "
               "(docs/user/radiometry.md)."},
      {.path = "output", .help = "What is written, and where."},
  };
}

std::vector<KeyDeclaration> make_keys() {
  std::vector<KeyDeclaration> keys;
  for (const auto part : {scene_keys, matter_keys, light_keys, run_keys, picture_keys, sensor_keys}) {
    std::vector<KeyDeclaration> some = part();
    keys.insert(keys.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  }
  return keys;
}

}  // namespace

std::vector<KeyDeclaration> declarations_of(std::initializer_list<KeyTable> tables) {
  std::vector<KeyDeclaration> declarations;
  for (const KeyTable& table : tables)
    declarations.insert(declarations.end(), table.declarations().begin(), table.declarations().end());
  return declarations;
}

std::span<const KeyDeclaration> key_declarations() {
  static const std::vector<KeyDeclaration> keys = make_keys();
  return keys;
}

std::span<const TableDeclaration> table_declarations() {
  static const std::vector<TableDeclaration> tables = make_tables();
  return tables;
}

}  // namespace etendue
