// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdlib>
#include <stdexcept>

#include "app/write/vtk/solution_bytes.h"
#include "base/errors.h"
#include "solver/transport/state/state_copy.h"

namespace {

constexpr int bands = 3;
constexpr std::size_t stride = 4;

}  // namespace

/// Bytes of the process that reads a saved solution are taken and restored in a state of a few cells, or
/// refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto saved = etendue::take_solution({reinterpret_cast<const char*>(data), size});
    if (!saved) return 0;
    etendue::TransportState state({8 * stride, 4 * stride, 4 * stride, 6 * stride, 3 * stride, 3 * stride});
    etendue::restore(saved->result.state, bands, state);
    if (etendue::saved(state, bands).fluence.size() != saved->result.state.fluence.size()) std::abort();
  } catch (const etendue::InputError&) {
  } catch (const std::runtime_error&) {
  }
  return 0;
}
