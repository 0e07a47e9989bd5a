// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/setup/memory.h"

#include <fmt/format.h>
#include <unistd.h>

#include "app/write/json/summary.h"
#include "base/errors.h"
#include "base/gibibyte.h"
#include "solver/transport/scattering/scattering_plan.h"

namespace etendue {
namespace {

constexpr double mebibyte = 1024.0 * 1024.0;

/// The program and its libraries, before a case [bytes].
constexpr double program_itself = 36e6;

/// How the cells are counted and the memory is bounded.
struct Precision {
  double expected;  ///< to solve [bytes]; 0: as much as at most
  std::string cells;
  std::string bound;
  std::string rest;  ///< what is said behind the memory
};

std::string checked(double solving, const Precision& precision, double cells, int bands,
                    const std::string& matrices) {
  // The files hold four values of the fluence and of three components of the net flux in each cell and band.
  const double writing = 4.0 * (1 + 3) * sizeof(double) * bands * cells;
  const double besides = program_itself + writing, needed = besides + solving;
  if (needed <= installed_memory()) {
    const std::string expected =
        precision.expected > 0 && precision.expected < solving
            ? fmt::format("about {:.3g} GiB, ", (besides + precision.expected) / gibibyte)
            : "";
    return fmt::format("memory: {}{} {:.3g} GiB{}{}\n", expected, precision.bound, needed / gibibyte,
                       matrices, precision.rest);
  }
  throw InputError(fmt::format(
      "mesh: {} cells and {} bands with these directions and phase functions may need {:.3g} GiB{} "
      "and this machine has "
      "{:.3g} GiB; use larger cells, fewer bands, directions or threads, or solve.method = "
      "\"source-iteration\"{}",
      precision.cells, bands, needed / gibibyte, matrices, installed_memory() / gibibyte,
      matrices.empty() ? "" : ", or scattering_method = \"moments\" where that will do"));
}

}  // namespace

double installed_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::string matrix_memory_text(const Problem& problem, const DirectionSet& directions) {
  const std::vector<ScatteringTreatment> plan = plan_scattering(problem, directions);
  const std::vector<double> bytes = angular_bytes(problem, directions);
  std::string text;
  for (std::size_t region = 0; region < bytes.size(); ++region)
    for (int band = 0; band < problem.band_count(); ++band) {
      if (!plan[region * static_cast<std::size_t>(problem.band_count()) + static_cast<std::size_t>(band)]
               .is_dense())
        continue;
      text += fmt::format("{}{:.3g} MiB for each angular solution of {}", text.empty() ? "" : ", ",
                          bytes[region] / mebibyte, problem.media()[region].name);
      break;
    }
  return text.empty() ? "" : " (scattering by a matrix: " + text + ")";
}

std::string check_memory(std::size_t solving, const TetrahedralMesh& mesh, int bands,
                         const std::string& matrices, std::size_t expected) {
  return checked(static_cast<double>(solving),
                 {static_cast<double>(expected), fmt::to_string(mesh.cell_count()), "at most", ""},
                 mesh.cell_count(), bands, matrices);
}

std::string check_expected_memory(double solving, double cells, int bands, const std::string& matrices) {
  const std::string about = fmt::format("about {:.2g}", cells);
  return checked(solving, {0, about, "about", fmt::format(" for {} cells (check --mesh counts them)", about)},
                 cells, bands, matrices);
}

std::string out_of_memory_message() {
  return fmt::format(
      "the case needs more memory than there is (at most {:.3g} GiB were in use, this machine has {:.3g} "
      "GiB); "
      "use larger cells or fewer bands",
      static_cast<double>(peak_memory()) / gibibyte, installed_memory() / gibibyte);
}

}  // namespace etendue
