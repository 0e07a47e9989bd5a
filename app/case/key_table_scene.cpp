// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/key_table.h"

namespace etendue {

using enum KeyType;
using namespace key_range;

std::vector<KeyDeclaration> scene_keys() {
  constexpr auto required = Need::required;
  const Range sphere_facets{.lowest = 8, .highest = 1e6};
  const Range cylinder_facets{.lowest = 3, .highest = 1e5};
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
       "split",
       integer,
       {.default_value = "0",
        .range = {.lowest = 0, .highest = 6},
        .help = "How often every cell is cut into eight, whatever it comes from; curved walls keep their "
                "facets."}},
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
  };
}

}  // namespace etendue
