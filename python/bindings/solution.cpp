// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/solution.h>

#include "python/bindings/bindings.h"
#include "python/bindings/interruption.h"

namespace etendue::python {
namespace {

const Solution& solution_of(const py::object& self) { return self.cast<const Solution&>(); }

/// A field [cell or boundary face][extents...][band].
template <class Get>
py::array field_of(const py::object& self, const Get& get, std::vector<py::ssize_t> extents) {
  const Solution& solution = solution_of(self);
  const std::span<const double> values = get(solution);
  const auto bands = static_cast<py::ssize_t>(solution.bands().size());
  py::ssize_t each = bands;
  for (const py::ssize_t extent : extents) each *= extent;
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(values.size()) / each};
  shape.insert(shape.end(), extents.begin(), extents.end());
  shape.push_back(bands);
  return shown(values, shape, self);
}

py::array fluence_at(const Solution& solution, const Numbers<double>& points) {
  if (points.ndim() != 2 || points.shape(1) != 3) throw py::value_error("points: an array of shape (n, 3)");
  std::vector<double> values;
  {
    const py::gil_scoped_release unlocked;
    values = solution.fluence_at(span_of(points));
  }
  return owned(std::move(values), {points.shape(0), static_cast<py::ssize_t>(solution.bands().size())});
}

py::list iterations(const Solution& solution) {
  py::list rows;
  for (const BandIteration& row : solution.iterations()) {
    py::dict dict;
    dict["band"] = row.band;
    dict["sweeps"] = row.sweeps;
    dict["residual"] = row.residual;
    dict["converged"] = row.converged;
    rows.append(dict);
  }
  return rows;
}

py::list balances(const Solution& solution) {
  py::list rows;
  for (const BandBalance& row : solution.balances()) {
    py::dict dict;
    dict["band"] = row.band;
    dict["emitted"] = row.emitted;
    dict["inflow"] = row.inflow;
    dict["absorbed"] = row.absorbed;
    dict["outflow"] = row.outflow;
    dict["residual"] = row.residual;
    rows.append(dict);
  }
  return rows;
}

py::list walls(const Solution& solution) {
  py::list rows;
  for (const WallTotals& row : solution.walls()) {
    py::dict dict;
    dict["wall"] = row.wall;
    dict["band"] = row.band;
    dict["area"] = row.area;
    dict["irradiance_mean"] = row.irradiance_mean;
    dict["incoming"] = row.incoming;
    dict["outgoing"] = row.outgoing;
    rows.append(dict);
  }
  return rows;
}

py::list regions(const Solution& solution) {
  py::list rows;
  for (const RegionTotals& row : solution.regions()) {
    py::dict dict;
    dict["region"] = row.region;
    dict["band"] = row.band;
    dict["volume"] = row.volume;
    dict["fluence_mean"] = row.fluence_mean;
    dict["absorbed"] = row.absorbed;
    dict["emitted"] = row.emitted;
    rows.append(dict);
  }
  return rows;
}

py::list probes(const Solution& solution) {
  py::list rows;
  for (const ProbeReading& row : solution.probes()) {
    py::dict dict;
    dict["probe"] = row.probe;
    dict["index"] = row.index;
    dict["x"] = row.point[0];
    dict["y"] = row.point[1];
    dict["z"] = row.point[2];
    dict["band"] = row.band;
    dict["fluence"] = row.fluence;
    dict["net_flux_x"] = row.net_flux[0];
    dict["net_flux_y"] = row.net_flux[1];
    dict["net_flux_z"] = row.net_flux[2];
    dict["irradiance"] = row.irradiance;
    rows.append(dict);
  }
  return rows;
}

py::list sensors(const Solution& solution) {
  py::list rows;
  for (const SensorReading& row : solution.sensors()) {
    py::dict dict;
    dict["sensor"] = row.sensor;
    dict["band"] = row.band;
    dict["quantity"] = row.quantity;
    dict["uncollided"] = row.uncollided;
    dict["collided"] = row.collided;
    dict["value"] = row.value;
    dict["error"] = row.error;
    dict["unit"] = row.unit;
    rows.append(dict);
  }
  return rows;
}

/// (radiance, srgb)
py::tuple render(const Solution& solution, const std::string& camera) {
  PythonInterruption interruption;
  Image image;
  try {
    const py::gil_scoped_release unlocked;
    image = solution.render(camera, [&] { return interruption.noted(); });
  } catch (const Stopped&) {
    interruption.rethrow();
    throw;
  }
  return py::make_tuple(owned(std::move(image.radiance), {image.height, image.width, image.bands}),
                        owned(std::move(image.srgb), {image.height, image.width, 3}));
}

}  // namespace

void bind_solution(py::module_& module) {
  const auto field = [](auto get, std::vector<py::ssize_t> extents) {
    return [get, extents](const py::object& self) { return field_of(self, get, extents); };
  };
  py::class_<Solution>(module, "Solution")
      .def_property_readonly("mesh", &Solution::mesh)
      .def_property_readonly("bands", &Solution::bands)
      .def_property_readonly("method", &Solution::method)
      .def_property_readonly("converged", &Solution::converged)
      .def_property_readonly("notes", &Solution::notes)
      .def_property_readonly("fluence", field([](const Solution& s) { return s.fluence(); }, {4}))
      .def_property_readonly("net_flux", field([](const Solution& s) { return s.net_flux(); }, {4, 3}))
      .def_property_readonly("irradiance", field([](const Solution& s) { return s.irradiance(); }, {3}))
      .def_property_readonly("exitance", field([](const Solution& s) { return s.exitance(); }, {3}))
      .def("fluence_at", &fluence_at)
      .def("iterations", &iterations)
      .def("balances", &balances)
      .def("walls", &walls)
      .def("regions", &regions)
      .def("probes", &probes)
      .def("sensors", &sensors)
      .def("render", &render)
      .def("write_fields", &Solution::write_fields, py::call_guard<py::gil_scoped_release>())
      .def("write", &Solution::write, py::call_guard<py::gil_scoped_release>());
}

}  // namespace etendue::python
