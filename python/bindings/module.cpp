// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/command.h>

#include <sstream>

#include "python/bindings/bindings.h"

namespace etendue::python {
namespace {

/// What the program says and returns, without the interpreter's lock.
py::tuple command(const std::vector<std::string>& arguments) {
  std::ostringstream out, err;
  int code = 0;
  {
    const py::gil_scoped_release unlocked;
    code = run_command(arguments, out, err);
  }
  return py::make_tuple(code, out.str(), err.str());
}

}  // namespace

PYBIND11_MODULE(_etendue, module) {
  bind_errors(module);
  bind_mesh(module);
  bind_case(module);
  bind_solution(module);
  bind_solve(module);
  module.def("command", &command, py::arg("arguments"));
  module.def("version", &version);
}

}  // namespace etendue::python
