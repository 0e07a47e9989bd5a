// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/solve.h>

#include "python/bindings/bindings.h"
#include "python/bindings/interruption.h"

namespace etendue::python {
namespace {

py::dict dict_of(const Progress& progress) {
  py::dict dict;
  dict["stage"] = progress.stage;
  dict["sweep"] = progress.sweep;
  dict["residual"] = std::vector<double>(progress.residual.begin(), progress.residual.end());
  dict["tolerance"] = progress.tolerance;
  dict["seconds"] = progress.seconds;
  dict["seconds_left"] = progress.seconds_left;
  return dict;
}

/// `progress` is called with a dictionary; where it returns False the iteration ends.
Solution solve_case(const Case& input, const Mesh* mesh, int threads, const py::object& progress) {
  PythonInterruption interruption;
  SolveSettings settings;
  settings.threads = threads;
  settings.stop = [&] { return interruption.noted(); };
  if (!progress.is_none())
    settings.progress = [&](const Progress& state) {
      const py::gil_scoped_acquire locked;
      try {
        return !progress(dict_of(state)).is(py::bool_(false));
      } catch (const py::error_already_set& error) {
        interruption.raise(error);
        return false;
      }
    };
  try {
    std::optional<Solution> solution;
    {
      const py::gil_scoped_release unlocked;
      solution = mesh == nullptr ? solve(input, settings) : solve(input, *mesh, settings);
    }
    interruption.rethrow();
    return *std::move(solution);
  } catch (const Stopped&) {
    interruption.rethrow();
    throw;
  }
}

}  // namespace

void bind_solve(py::module_& module) {
  module.def("solve", &solve_case);
  module.def("check", &check, py::call_guard<py::gil_scoped_release>());
}

}  // namespace etendue::python
