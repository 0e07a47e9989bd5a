// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/case_tables.h"

namespace etendue {

using enum KeyType;
using namespace key_range;

const BoundTable<CameraCase>& camera_table() {
  static const BoundTable<CameraCase> table = [] {
    BoundTable<CameraCase> t("camera");
    t.key("name", text, {.need = required}, "Of the files NAME.exr and NAME.png.");
    t.key("position", member_of(&CameraCase::camera, &Camera::position), {.unit = "length", .need = required},
          "Where it stands; outside of the domain it looks in through walls that turn their backs to it.");
    t.key("look_at", member_of(&CameraCase::camera, &Camera::look_at), {.unit = "length", .need = required},
          "What is in the middle of the picture.");
    t.key("up", member_of(&CameraCase::camera, &Camera::up), {}, "What points up in the picture.");
    t.key("field_of_view", number,
          {.unit = "degrees",
           .default_note = "50; of a fisheye 180",
           .range = {.lowest = 0, .highest = 360, .lowest_excluded = true}},
          "Vertical angle that the picture shows, below 180; of a fisheye the angle across its circle.");
    t.key("projection", text,
          {.default_note = "\"perspective\"; with `orthographic` \"orthographic\"",
           .choices = {"perspective", "orthographic", "fisheye", "fisheye-equisolid"}},
          "Of a fisheye the distance from the middle is as the angle from the view (equidistant), or as the "
          "sine of its half (equal areas are equal solid angles); its circle is as wide as the shorter side "
          "of the picture.");
    t.key("orthographic", number, {.unit = "length", .range = positive},
          "Height that the picture shows, by parallel rays; in place of `field_of_view`.");
    t.key("pixels", member_of(&CameraCase::camera, &Camera::pixels),
          {.range = {.lowest = 1, .highest = 32768}}, "Across and down.");
    t.key("samples", member_of(&CameraCase::camera, &Camera::samples),
          {.choices = {"1", "4", "9", "16", "25", "36", "49", "64"}}, "Rays in a pixel, on a square grid.");
    t.key("shaft_points", member_of(&CameraCase::camera, &Camera::shafts),
          {.range = {.lowest = 0, .highest = 64}, .former_name = "shafts"},
          "Points in each cell on a ray that are lit by rays to the lights: crisp shafts, at the cost of as "
          "many rays. 0: light that scatters once is taken linear in a cell.");
    t.key(
        "gather_rays", member_of(&CameraCase::camera, &Camera::gather),
        {.choices = {"0", "64", "144", "256", "576", "1024"}, .former_name = "gather"},
        "Rays from each vertex of a wall by which its irradiance is integrated anew (final gathering): free "
        "of ray effects, at the cost of as many rays. 0: the irradiance of the solution.");
    t.key("glossy_rays", member_of(&CameraCase::camera, &Camera::glossy),
          {.range = {.lowest = 0, .highest = 1024}, .former_name = "glossy"},
          "Rays from a point of a glossy wall, drawn from its reflectance. 0: it is seen as a diffuse one "
          "that reflects as much on the mean. Without effect on a photon map.");
    t.key("shadow_rays", member_of(&CameraCase::camera, &Camera::shadow_rays),
          {.range = {.lowest = 1, .highest = 4096}},
          "From each point of a wall to each light with an extent, at most: 16, and more where not all of "
          "these fare alike. Above 16 lamps of few flat pieces are cut along the edges that hide them, with "
          "as many rays as that needs, and their penumbras have no steps; 16 make quick pictures.");
    t.key("errors", member_of(&CameraCase::camera, &Camera::errors), {},
          "Estimates of each pixel's error as channels of NAME.exr: of the cells, and, in a run with "
          "directions.rotations, of the directions; each takes as long as the picture.");
    t.key("exposure", &CameraCase::exposure,
          {.default_note = "95 % of the picture are below white", .range = positive},
          "What radiance is multiplied by before the tone curve; for NAME.png only.");
    t.key("white", &CameraCase::white,
          {.unit = "K", .range = {.lowest = 1000, .highest = 1e6}, .choices = {"equal", "D65"}},
          "Light that is neutral in the picture: equal power in each nanometer (and a single band is grey), "
          "daylight D65 (colors as they are), or a black body of this temperature; for NAME.png only.");
    t.choice("tone", &CameraCase::tone,
             {{"linear", Tone::linear}, {"reinhard", Tone::reinhard}, {"aces", Tone::aces}}, {},
             "Curve that brings brightness into the range of a display: clipped, Reinhard's by luminance, or "
             "a fit to that of ACES; for NAME.png only.");
    return t;
  }();
  return table;
}

const BoundTable<FalseColor>& false_color_table() {
  static const BoundTable<FalseColor> table = [] {
    BoundTable<FalseColor> t("camera.false_color");
    t.choice("quantity", &FalseColor::quantity,
             {{"luminance", FalseColorQuantity::luminance}, {"radiance", FalseColorQuantity::radiance}}, {},
             "luminance in `units.luminance`, where the eye sees the bands; radiance of all bands together.");
    t.key("max", &FalseColor::most,
          {.unit = "that of the quantity",
           .default_note = "the largest value of the picture",
           .range = positive},
          "At the upper end of the scale.");
    t.key("min", &FalseColor::least,
          {.unit = "that of the quantity",
           .default_note = "0; of a logarithmic scale max/1000",
           .range = not_negative},
          "At its lower end.");
    t.key("log", &FalseColor::logarithmic, {}, "Whether the scale is logarithmic.");
    return t;
  }();
  return table;
}

std::vector<KeyDeclaration> picture_keys() { return declarations_of({camera_table(), false_color_table()}); }

}  // namespace etendue
