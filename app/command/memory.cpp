// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/memory.h"

#include <fmt/format.h>
#include <unistd.h>

#include "app/write/summary.h"
#include "mesh/base/errors.h"

namespace etendue {
namespace {

constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;

double installed_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

void check_memory(std::size_t solving, const TetrahedralMesh& mesh, int bands) {
  // The files hold four values of the fluence and of three components of the net flux in each cell and band.
  const double writing = 4.0 * (1 + 3) * sizeof(double) * bands * mesh.cell_count();
  const double needed = static_cast<double>(solving) + writing;
  if (needed <= installed_memory()) return;
  throw InputError(
      fmt::format("mesh: {} cells and {} bands with these directions and phase functions may need {:.3g} GiB "
                  "and this machine has "
                  "{:.3g} GiB; use larger cells, fewer bands, directions or threads, or solve.method = "
                  "\"source-iteration\"",
                  mesh.cell_count(), bands, needed / gibibyte, installed_memory() / gibibyte));
}

std::string out_of_memory_message() {
  return fmt::format(
      "the case needs more memory than there is (at most {:.3g} GiB were in use, this machine has {:.3g} "
      "GiB); "
      "use larger cells or fewer bands",
      static_cast<double>(peak_memory()) / gibibyte, installed_memory() / gibibyte);
}

}  // namespace etendue
