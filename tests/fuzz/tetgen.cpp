// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/tetgen_files.h"

#include "base/errors.h"
#include "tests/fuzz/check_raw_mesh.h"
#include "tests/fuzz/input_parts.h"

/// A mesh of TetGen, whose three files are the parts of the input, is read as tetrahedra whose points,
/// regions and walls exist, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  etendue::test::write_parts(data, size, {"mesh.node", "mesh.ele", "mesh.face"});
  try {
    etendue::test::check(etendue::read_tetgen_files(etendue::test::input_folder().path() / "mesh.node"));
  } catch (const etendue::InputError&) {
  } catch (const etendue::FileError&) {
  }
  return 0;
}
