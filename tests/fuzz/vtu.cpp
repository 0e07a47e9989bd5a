// SPDX-License-Identifier: AGPL-3.0-or-later
#include <stdexcept>
#include <string_view>

#include "base/errors.h"
#include "mesh/files/vtk/raw_mesh_bytes.h"
#include "mesh/files/vtk/vtu_header.h"
#include "tests/fuzz/input_file.h"

namespace {

template <class Take>
void take(Take take_mesh, const std::uint8_t* data, std::size_t size) {
  try {
    take_mesh(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const std::runtime_error&) {
  }
}

}  // namespace

/// The header of a VTK file is accepted or refused, and so is the mesh that the process that reads it leaves.
/// VTK itself is left out.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const etendue::test::InputFile file(data, size);
  try {
    etendue::check_vtu_header(file.path());
  } catch (const etendue::InputError&) {
  }
  take(etendue::take_raw_mesh, data, size);
  take(etendue::take_polyhedral_mesh, data, size);
  return 0;
}
