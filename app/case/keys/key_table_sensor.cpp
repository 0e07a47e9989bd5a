// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/key_table.h"

namespace etendue {

using enum KeyType;
using namespace key_range;

namespace {

KeyTable sensor_table() {
  KeyTable t("sensor");
  t.key("name", text, {.need = required}, "Names the rows in `sensors.csv`.");
  t.key("kind", text,
        {.default_value = "\"irradiance\"",
         .choices = {"irradiance", "exitance", "radiosity", "fluence", "radiance", "cone", "grid", "flux",
                     "intensity", "region", "glare"}},
        "irradiance on one side of a plane; exitance, also called radiosity: light that leaves a wall at a "
        "point, emitted, reflected and transmitted; fluence from all sides; radiance from one direction; of "
        "a cone the mean radiance and what it brings to the plane across it; grid: irradiance at the middles "
        "of parts of a parallelogram; flux: power through a polygon, a wall or the surface of a region, both "
        "ways; intensity of light that leaves the domain by a wall, over directions; region: the account of "
        "its light; glare: UGR and DGP of an observer.");
  t.key("position", point, {.unit = "length"}, "Where it stands; of a grid its first corner.");
  t.key("normal", point, {.default_note = "of a grid: along × across"},
        "Of irradiance: to the side where light is measured; of exitance and radiosity: into the domain; of "
        "any length.");
  t.key("direction", point, {},
        "Of radiance, cone and glare: where the sensor looks, against the light; of any length. Of a flux: "
        "the axis of the cone that light comes from.");
  t.key("angle", number, {.unit = "degrees", .range = {.lowest = 0, .highest = 90, .lowest_excluded = true}},
        "Half angle of a cone; of a flux or a region it leaves out light that comes from elsewhere.");
  t.key("along", point, {.unit = "length"}, "Side of a grid, from its corner.");
  t.key("across", point, {.unit = "length"}, "Its other side.");
  t.key("parts", numbers,
        {.default_note = "[4, 4]; of a flux [4], through a wall [1], of intensity [24, 19], of glare [360]",
         .range = {.lowest = 1, .highest = 4096}},
        "Of a grid: parts along and across. Of a flux: n, and 3 n^2 points for each triangle about the "
        "polygon's first corner, or for each face of the wall. Of intensity: azimuths, and polar angles from "
        "0 to 90 degrees. Of glare: pixels across the view of 180 degrees.");
  t.key("wall", text, {},
        "Of intensity: the wall that the light leaves by. Of a flux: in place of a polygon; forward is out "
        "of the domain.");
  t.key("region", text, {},
        "Of a region: its name. Of a flux: in place of a polygon, and forward is out of the region. The "
        "radiance of all directions is kept in memory for it.");
  t.key("beyond", text, {.default_note = "all of the surface"},
        "Of a flux through the surface of a region: the region or wall on the other side of the faces that "
        "count.");
  t.key("polygon", points, {.unit = "length"},
        "Corners of a flux in order, in one plane; sides meet at common corners alone. Forward is to where "
        "they are seen counterclockwise.");
  t.key("daylight_factor", boolean, {.default_value = "false"},
        "Of irradiance and grid: also the daylight factor, in percent of what the unobstructed sky brings to "
        "a horizontal plane. The sky must be the only light.");
  t.key("up", point, {.default_value = "[0, 0, 1]"}, "Of glare: what points up for the observer.");
  t.key("sources", text, {.default_value = "\"threshold\"", .choices = {"threshold", "lights"}},
        "Of glare: its sources are all that is brighter than `threshold`, or the lights that are seen, each "
        "alone.");
  t.key("threshold", number, {.unit = "cd/m^2", .default_value = "2000", .range = positive},
        "Of glare: luminance from which on something is a source; up to 100 a factor of the mean luminance "
        "of the view.");
  t.key("rays", integer, {.default_value = "2000", .range = {.lowest = 68, .highest = largest_count}},
        "From each point at most, for light that has been scattered or reflected; fewer where 1e-6 is "
        "reached. The error that they leave is written.");
  return t;
}

}  // namespace

std::vector<KeyDeclaration> sensor_keys() { return declarations_of({sensor_table()}); }

}  // namespace etendue
