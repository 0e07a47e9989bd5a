// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/key_table.h"

namespace etendue {

using enum KeyType;
using namespace key_range;

std::vector<KeyDeclaration> picture_keys() {
  constexpr auto required = Need::required;
  return {
      {"camera", "name", text, {.need = required, .help = "Of the files NAME.exr and NAME.png."}},
      {"camera",
       "position",
       point,
       {.unit = "length",
        .need = required,
        .help = "Where it stands; outside of the domain it looks in through walls that turn their backs to "
                "it."}},
      {"camera",
       "look_at",
       point,
       {.unit = "length", .need = required, .help = "What is in the middle of the picture."}},
      {"camera", "up", point, {.default_value = "[0, 0, 1]", .help = "What points up in the picture."}},
      {"camera",
       "field_of_view",
       number,
       {.unit = "degrees",
        .default_note = "50; of a fisheye 180",
        .range = {.lowest = 0, .highest = 360, .lowest_excluded = true},
        .help =
            "Vertical angle that the picture shows, below 180; of a fisheye the angle across its circle."}},
      {"camera",
       "projection",
       text,
       {.default_note = "\"perspective\"; with `orthographic` \"orthographic\"",
        .choices = {"perspective", "orthographic", "fisheye", "fisheye-equisolid"},
        .help = "Of a fisheye the distance from the middle is as the angle from the view (equidistant), or "
                "as the "
                "sine of its half (equal areas are equal solid angles); its circle is as wide as the shorter "
                "side of the picture."}},
      {"camera",
       "orthographic",
       number,
       {.unit = "length",
        .range = positive,
        .help = "Height that the picture shows, by parallel rays; in place of `field_of_view`."}},
      {"camera",
       "pixels",
       numbers,
       {.default_value = "[800, 600]", .range = {.lowest = 1, .highest = 32768}, .help = "Across and down."}},
      {"camera",
       "samples",
       integer,
       {.default_value = "1",
        .choices = {"1", "4", "9", "16", "25", "36", "49", "64"},
        .help = "Rays in a pixel, on a square grid."}},
      {"camera",
       "shaft_points",
       integer,
       {.default_value = "0",
        .range = {.lowest = 0, .highest = 64},
        .former_name = "shafts",
        .help = "Points in each cell on a ray that are lit by rays to the lights: crisp shafts, at the cost "
                "of as many rays. 0: light that scatters once is taken linear in a cell."}},
      {"camera",
       "gather_rays",
       integer,
       {.default_value = "0",
        .choices = {"0", "64", "144", "256", "576", "1024"},
        .former_name = "gather",
        .help =
            "Rays that look from each vertex of a wall for the light that directions brought there: free of "
            "their rays, at the cost of as many rays. 0: as the solution has it."}},
      {"camera",
       "glossy_rays",
       integer,
       {.default_value = "16",
        .range = {.lowest = 0, .highest = 1024},
        .former_name = "glossy",
        .help =
            "Rays from a point of a glossy wall, drawn from its reflectance. 0: it is seen as a diffuse one "
            "that reflects as much on the mean. Without effect on a photon map."}},
      {"camera",
       "shadow_rays",
       integer,
       {.default_value = "128",
        .range = {.lowest = 1, .highest = 4096},
        .help =
            "From each point of a wall to each light with an extent, at most: 16, and more where not all of "
            "these fare alike. Above 16 lamps of few flat pieces are cut along the edges that hide them, "
            "with as "
            "many rays as that needs, and their penumbras have no steps; 16 make quick pictures."}},
      {"camera",
       "errors",
       boolean,
       {.default_value = "false",
        .help = "Estimates of each pixel's error as channels of NAME.exr: of the cells, and, in a run with "
                "directions.rotations, of the directions; each takes as long as the picture."}},
      {"camera",
       "exposure",
       number,
       {.default_note = "95 % of the picture are below white",
        .range = positive,
        .help = "What radiance is multiplied by before the tone curve; for NAME.png only."}},
      {"camera.false_color",
       "quantity",
       text,
       {.default_value = "\"luminance\"",
        .choices = {"luminance", "radiance"},
        .help =
            "luminance in `units.luminance`, where the eye sees the bands; radiance of all bands together."}},
      {"camera.false_color",
       "max",
       number,
       {.unit = "that of the quantity",
        .default_note = "the largest value of the picture",
        .range = positive,
        .help = "At the upper end of the scale."}},
      {"camera.false_color",
       "min",
       number,
       {.unit = "that of the quantity",
        .default_note = "0; of a logarithmic scale max/1000",
        .range = not_negative,
        .help = "At its lower end."}},
      {"camera.false_color",
       "log",
       boolean,
       {.default_value = "false", .help = "Whether the scale is logarithmic."}},
      {"camera",
       "white",
       choice_or_number,
       {.unit = "K",
        .default_value = "\"equal\"",
        .range = {.lowest = 1000, .highest = 1e6},
        .choices = {"equal", "D65"},
        .help =
            "Light that is neutral in the picture: equal power in each nanometer (and a single band is "
            "grey), "
            "daylight D65 (colors as they are), or a black body of this temperature; for NAME.png only."}},
      {"camera",
       "tone",
       text,
       {.default_value = "\"linear\"",
        .choices = {"linear", "reinhard", "aces"},
        .help = "Curve that brings brightness into the range of a display: clipped, Reinhard's by luminance, "
                "or a fit to that of ACES; for NAME.png only."}},
  };
}

}  // namespace etendue
