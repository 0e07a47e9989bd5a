// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/case.h>

#include "python/bindings/bindings.h"

namespace etendue::python {

void bind_case(py::module_& module) {
  py::class_<Case>(module, "Case")
      .def_static("from_file", &Case::from_file, py::arg("file"), py::arg("overrides") = Case::Overrides{},
                  py::call_guard<py::gil_scoped_release>())
      .def_static(
          "from_text",
          [](const std::string& text, const Mesh* mesh, const std::filesystem::path& file,
             const Case::Overrides& overrides) {
            return mesh == nullptr ? Case::from_text(text, file, overrides)
                                   : Case::from_text(text, *mesh, file, overrides);
          },
          py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("title", &Case::title)
      .def_property_readonly("bands", &Case::bands)
      .def_property_readonly("cameras", &Case::cameras)
      .def_property_readonly("length_unit", &Case::length_unit)
      .def_property_readonly("power_unit", &Case::power_unit)
      .def_property_readonly("resolved_toml", &Case::resolved_toml)
      .def("mesh", &Case::mesh, py::call_guard<py::gil_scoped_release>());
}

}  // namespace etendue::python
