// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/openfoam/foam_mesh.h"

#include <memory>

#include "base/errors.h"
#include "mesh/tetrahedra/generation/cut_polyhedra.h"
#include "tests/fuzz/check_raw_mesh.h"
#include "tests/fuzz/input_parts.h"

/// A mesh of OpenFOAM, whose files are the parts of the input, is read and cut into tetrahedra whose points,
/// regions and walls exist, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::filesystem::create_directory(etendue::test::input_folder().path() / "polyMesh");
  etendue::test::write_parts(data, size,
                             {"polyMesh/points", "polyMesh/faces", "polyMesh/owner", "polyMesh/neighbour",
                              "polyMesh/boundary", "polyMesh/cellZones"});
  try {
    etendue::test::check(etendue::cut_polyhedra(std::make_shared<const etendue::PolyhedralMesh>(
        etendue::read_foam_mesh(etendue::test::input_folder().path()))));
  } catch (const etendue::InputError&) {
  } catch (const etendue::FileError&) {
  }
  return 0;
}
