// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <span>
#include <vector>

namespace etendue::python {

namespace py = pybind11;

// Each adds a part of the module.
void bind_errors(py::module_& module);
void bind_mesh(py::module_& module);
void bind_case(py::module_& module);
void bind_solution(py::module_& module);
void bind_solve(py::module_& module);

/// An array that shows values of the library, which `owner` keeps alive: nothing is copied, and it cannot be
/// written to.
template <class Number>
py::array shown(std::span<const Number> values, const std::vector<py::ssize_t>& shape, py::handle owner) {
  py::array array(py::dtype::of<Number>(), shape, values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// An array that owns its values.
template <class Number>
py::array owned(std::vector<Number> values, const std::vector<py::ssize_t>& shape) {
  auto* kept = new std::vector<Number>(std::move(values));
  const py::capsule owner(kept, [](void* pointer) { delete static_cast<std::vector<Number>*>(pointer); });
  return py::array(py::dtype::of<Number>(), shape, kept->data(), owner);
}

/// Numbers of an array of some shape, in C order; copied only where they are not.
template <class Number>
using Numbers = py::array_t<Number, py::array::c_style | py::array::forcecast>;

template <class Number>
std::span<const Number> span_of(const Numbers<Number>& numbers) {
  return {numbers.data(), static_cast<std::size_t>(numbers.size())};
}

}  // namespace etendue::python
