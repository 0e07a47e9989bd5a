// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/solution.h>

#include "python/bindings/bindings.h"
#include "python/bindings/interruption.h"

namespace etendue::python {
namespace {

using namespace pybind11::literals;

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

/// A list of what a function makes of each row.
template <class Rows, class AsDict>
py::list list_of(const Rows& rows, const AsDict& as_dict) {
  py::list list;
  for (const auto& row : rows) list.append(as_dict(row));
  return list;
}

py::list iterations(const Solution& solution) {
  return list_of(solution.iterations(), [](const BandIteration& row) {
    return py::dict("band"_a = row.band, "sweeps"_a = row.sweeps, "residual"_a = row.residual,
                    "converged"_a = row.converged);
  });
}

py::list balances(const Solution& solution) {
  return list_of(solution.balances(), [](const BandBalance& row) {
    return py::dict("band"_a = row.band, "emitted"_a = row.emitted, "inflow"_a = row.inflow,
                    "absorbed"_a = row.absorbed, "outflow"_a = row.outflow, "residual"_a = row.residual);
  });
}

py::list walls(const Solution& solution) {
  return list_of(solution.walls(), [](const WallTotals& row) {
    return py::dict("wall"_a = row.wall, "band"_a = row.band, "area"_a = row.area,
                    "irradiance_mean"_a = row.irradiance_mean, "incoming"_a = row.incoming,
                    "outgoing"_a = row.outgoing);
  });
}

py::list regions(const Solution& solution) {
  return list_of(solution.regions(), [](const RegionTotals& row) {
    return py::dict("region"_a = row.region, "band"_a = row.band, "volume"_a = row.volume,
                    "fluence_mean"_a = row.fluence_mean, "absorbed"_a = row.absorbed,
                    "emitted"_a = row.emitted);
  });
}

py::list heat(const Solution& solution) {
  return list_of(solution.heat(), [](const HeatTotals& row) {
    return py::dict("kind"_a = row.kind, "name"_a = row.name, "extent"_a = row.extent,
                    "emitted"_a = row.emitted, "absorbed"_a = row.absorbed, "net"_a = row.net,
                    "conducted"_a = row.conducted, "convected"_a = row.convected,
                    "temperature"_a = row.temperature);
  });
}

py::array cell_temperature(const Solution& solution) {
  std::vector<double> kelvin = solution.cell_temperature();
  const auto cells = static_cast<py::ssize_t>(kelvin.size());
  return owned(std::move(kelvin), {cells});
}

py::array wall_temperature(const Solution& solution) {
  std::vector<double> kelvin = solution.wall_temperature();
  const auto faces = static_cast<py::ssize_t>(kelvin.size() / 3);
  return owned(std::move(kelvin), {faces, 3});
}

py::list probes(const Solution& solution) {
  return list_of(solution.probes(), [](const ProbeReading& row) {
    return py::dict("probe"_a = row.probe, "index"_a = row.index, "x"_a = row.point[0], "y"_a = row.point[1],
                    "z"_a = row.point[2], "band"_a = row.band, "fluence"_a = row.fluence,
                    "net_flux_x"_a = row.net_flux[0], "net_flux_y"_a = row.net_flux[1],
                    "net_flux_z"_a = row.net_flux[2], "irradiance"_a = row.irradiance);
  });
}

py::list sensors(const Solution& solution) {
  return list_of(solution.sensors(), [](const SensorReading& row) {
    return py::dict("sensor"_a = row.sensor, "band"_a = row.band, "quantity"_a = row.quantity,
                    "uncollided"_a = row.uncollided, "collided"_a = row.collided, "value"_a = row.value,
                    "error"_a = row.error, "unit"_a = row.unit);
  });
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
      .def("heat", &heat)
      .def("cell_temperature", &cell_temperature)
      .def("wall_temperature", &wall_temperature)
      .def("probes", &probes)
      .def("sensors", &sensors)
      .def("render", &render)
      .def("write_fields", &Solution::write_fields, py::call_guard<py::gil_scoped_release>())
      .def("write", &Solution::write, py::call_guard<py::gil_scoped_release>());
}

}  // namespace etendue::python
