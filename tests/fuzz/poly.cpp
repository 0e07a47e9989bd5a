// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdlib>

#include "base/errors.h"
#include "mesh/geometry/surface_files/tetgen_surface.h"
#include "tests/fuzz/input_parts.h"

namespace {

bool is_index(int index, std::size_t count) { return index >= 0 && static_cast<std::size_t>(index) < count; }

void check(const etendue::SurfaceComplex& surface) {
  for (const etendue::SurfaceFacet& facet : surface.facets) {
    if (!is_index(facet.wall, surface.wall_names.size())) std::abort();
    for (const std::vector<int>& polygon : facet.polygons)
      for (const int point : polygon)
        if (!is_index(point, surface.points.size())) std::abort();
  }
  for (const etendue::RegionSeed& seed : surface.seeds)
    if (!is_index(seed.region, surface.region_names.size())) std::abort();
}

}  // namespace

/// A .poly file, and the same text as a .smesh file, is read as facets whose points, walls and regions exist,
/// or refused. A second part of the input is the .node file beside it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const char* name : {"surface.poly", "surface.smesh"}) {
    etendue::test::write_parts(data, size, {name, "surface.node"});
    try {
      check(etendue::read_tetgen_surface(etendue::test::input_folder().path() / name, {}));
    } catch (const etendue::InputError&) {
    } catch (const etendue::FileError&) {
    }
  }
  return 0;
}
