// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/readings/probes.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "base/parallel/parallel_for.h"
#include "mesh/tetrahedra/bounding_box.h"

namespace etendue {
namespace {

std::string text_of(const Vec3& point) {
  return fmt::format("[{}, {}, {}]", point.x(), point.y(), point.z());
}

Fault probe_outside(const Probe& probe, const Vec3& point, const TetrahedralMesh& mesh) {
  const auto [low, high] = bounding_box(mesh.points());
  return fault_at(
      probe.origin, text_of(point),
      fmt::format("the point of probe \"{}\" lies outside the mesh (which reaches from {} to {}); "
                  "move it into a region",
                  probe.name, text_of(low), text_of(high)));
}

/// Puts the uncollided light at the point in the place of its projection.
void make_exact(const LightSetup& lights, const Solution& solution, const CellLocator& locator,
                ProbeRow& row) {
  const std::vector<ProbeValue> projected = probe_uncollided(lights.problem(), solution, locator, row.point);
  const LightAtPoint exact = lights.at({locator.find(row.point).front().cell, row.point}, std::nullopt);
  row.fluence_field.emplace();
  for (std::size_t b = 0; b < row.values.size(); ++b) {
    row.fluence_field->push_back(row.values[b].fluence);
    row.values[b].fluence += exact.fluence[b] - projected[b].fluence;
    for (std::size_t axis = 0; axis < 3; ++axis)
      row.values[b].net_flux[axis] +=
          exact.net_flux[b][static_cast<Eigen::Index>(axis)] - projected[b].net_flux[axis];
  }
}

}  // namespace

std::vector<IrradianceMeter> place_probes(const std::vector<Probe>& probes, const TetrahedralMesh& mesh,
                                          const CellLocator& locator) {
  std::vector<IrradianceMeter> meters;
  std::vector<Fault> faults;
  for (const Probe& probe : probes)
    for (const Vec3& point : probe.points) {
      std::vector<CellPoint> cells = locator.find(point);
      if (cells.empty()) faults.push_back(probe_outside(probe, point, mesh));
      if (probe.normal) meters.push_back({std::move(cells), *probe.normal});
    }
  if (!faults.empty()) throw InputError(std::move(faults));
  return meters;
}

std::vector<ProbeRow> read_probes(const std::vector<Probe>& probes, const LightSetup& lights,
                                  const Solution& solution, const CellLocator& locator, int threads,
                                  const StageObserver& observer) {
  const Problem& problem = lights.problem();
  const auto bands = static_cast<std::ptrdiff_t>(problem.band_count());
  std::vector<ProbeRow> rows;
  auto meter = solution.meters.begin();
  for (const Probe& place : probes)
    for (std::size_t i = 0; i < place.points.size(); ++i) {
      ProbeRow row{place.name, static_cast<int>(i), place.points[i], {}, {}, {}};
      if (place.normal) {
        row.irradiance.emplace(meter, meter + bands);
        meter += bands;
      }
      rows.push_back(std::move(row));
    }
  StageCounter counter(rows.size(), observer);
  parallel_for(rows.size(), threads, 1, [&](std::size_t i) {
    ProbeRow& row = rows[i];
    row.values = probe(problem, solution, locator, row.point);
    if (!lights.empty()) make_exact(lights, solution, locator, row);
    return counter.add();
  });
  std::erase_if(rows, [](const ProbeRow& row) { return row.values.empty(); });
  return rows;
}

}  // namespace etendue
