// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/gmsh_file.h"

#include "base/errors.h"
#include "tests/fuzz/check_raw_mesh.h"
#include "tests/fuzz/input_file.h"

/// A Gmsh mesh is read as tetrahedra whose points, regions and walls exist, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const etendue::test::InputFile file(data, size);
  try {
    etendue::test::check(etendue::read_gmsh_file(file.path()));
  } catch (const etendue::InputError&) {
  }
  return 0;
}
