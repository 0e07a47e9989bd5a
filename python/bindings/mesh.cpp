// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/mesh.h>

#include "python/bindings/bindings.h"

namespace etendue::python {
namespace {

const Mesh& mesh_of(const py::object& self) { return self.cast<const Mesh&>(); }

py::ssize_t count(std::size_t size) { return static_cast<py::ssize_t>(size); }

Mesh from_arrays(const Numbers<double>& points, const Numbers<std::int32_t>& cells,
                 const Numbers<std::int32_t>& regions, std::vector<std::string> region_names,
                 const Numbers<std::int32_t>& triangles, const Numbers<std::int32_t>& walls,
                 std::vector<std::string> wall_names) {
  const MeshArrays arrays{span_of(points),    span_of(cells), span_of(regions),     std::move(region_names),
                          span_of(triangles), span_of(walls), std::move(wall_names)};
  const py::gil_scoped_release unlocked;
  return Mesh::from_arrays(arrays);
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<Mesh>(module, "Mesh")
      .def_static("from_arrays", &from_arrays)
      .def_static(
          "from_file",
          [](const std::filesystem::path& file, double scale) { return Mesh::from_file(file, scale); },
          py::call_guard<py::gil_scoped_release>())
      .def("write", &Mesh::write, py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("point_count", &Mesh::point_count)
      .def_property_readonly("cell_count", &Mesh::cell_count)
      .def_property_readonly("region_names", &Mesh::region_names)
      .def_property_readonly("wall_names", &Mesh::wall_names)
      .def_property_readonly("points",
                             [](const py::object& self) {
                               const auto values = mesh_of(self).points();
                               return shown(values, {count(values.size() / 3), 3}, self);
                             })
      .def_property_readonly("cells",
                             [](const py::object& self) {
                               const auto values = mesh_of(self).cells();
                               return shown(values, {count(values.size() / 4), 4}, self);
                             })
      .def_property_readonly("cell_regions",
                             [](const py::object& self) {
                               const auto values = mesh_of(self).cell_regions();
                               return shown(values, {count(values.size())}, self);
                             })
      .def_property_readonly("volumes",
                             [](const py::object& self) {
                               const auto values = mesh_of(self).volumes();
                               return shown(values, {count(values.size())}, self);
                             })
      .def_property_readonly("boundary_faces",
                             [](const py::object& self) {
                               const auto values = mesh_of(self).boundary_faces();
                               return shown(values, {count(values.size() / 3), 3}, self);
                             })
      .def_property_readonly("parents",
                             [](const py::object& self) {
                               const auto values = mesh_of(self).parents();
                               return shown(values, {count(values.size())}, self);
                             })
      .def_property_readonly("face_walls", [](const py::object& self) {
        const auto values = mesh_of(self).face_walls();
        return shown(values, {count(values.size())}, self);
      });
}

}  // namespace etendue::python
