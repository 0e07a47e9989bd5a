// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/errors.h>

#include "python/bindings/bindings.h"

namespace etendue::python {
namespace {

/// [(file, line, text)]
py::list faults_of(const InputError& error) {
  py::list faults;
  for (const Fault& fault : error.faults()) faults.append(py::make_tuple(fault.file, fault.line, fault.text));
  return faults;
}

}  // namespace

// The classes are those of etendue/errors.py, so that they have documentation and attributes.
void bind_errors(py::module_& module) {
  const py::module_ classes = py::module_::import("etendue.errors");
  for (const char* name : {"InputError", "FileError", "NotFiniteError", "Stopped"})
    module.attr(name) = classes.attr(name);
  py::register_local_exception_translator([](std::exception_ptr pointer) {
    const auto raise = [](const char* name, const std::exception& error) {
      const py::object type = py::module_::import("etendue.errors").attr(name);
      PyErr_SetString(type.ptr(), error.what());
    };
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const InputError& error) {
      const py::object type = py::module_::import("etendue.errors").attr("InputError");
      const py::object instance = type(error.what(), faults_of(error));
      PyErr_SetObject(type.ptr(), instance.ptr());
    } catch (const FileError& error) {
      raise("FileError", error);
    } catch (const NotFiniteError& error) {
      raise("NotFiniteError", error);
    } catch (const Stopped& error) {
      raise("Stopped", error);
    }
  });
}

}  // namespace etendue::python
