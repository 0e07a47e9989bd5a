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

void check_memory(const TetrahedralMesh& mesh, int bands) {
  // In each cell and band four values of the fluence and of the three components of the net flux, once in the
  // solution and once in the file that is written.
  const double needed = 2.0 * 4 * (1 + 3) * sizeof(double) * bands * mesh.cell_count();
  if (needed <= installed_memory()) return;
  throw InputError(fmt::format(
      "mesh: the fields of {} cells and {} bands need {:.3g} GiB and this machine has {:.3g} GiB; use larger "
      "cells or fewer bands",
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
