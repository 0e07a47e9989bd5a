// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/projection/uncollided_field.h"

#include <array>
#include <optional>

#include "base/field_view.h"
#include "base/parallel/parallel_for.h"
#include "base/quadrature/cell_rule.h"
#include "solver/uncollided/projection/cell_light.h"
#include "solver/uncollided/projection/directional_losses.h"
#include "solver/uncollided/projection/extended_collisions.h"
#include "solver/uncollided/projection/extended_light.h"
#include "solver/uncollided/projection/face_light.h"
#include "solver/uncollided/projection/sky_light.h"

namespace etendue {
namespace {

/// Where a medium varies in a cell: the product of fluence and coefficients, both linear.
void add_varying_losses(const LightPaths& paths, const LitCell& cell, NodalMoments& moments) {
  const RayMatter::View any;  // asked only where directions are alike
  for (std::size_t b = 0; b < paths.bands(); ++b) {
    std::array<double, 4> fluence{};
    for (std::size_t i = 0; i < 4; ++i) fluence[i] = moments.nodal(i, 0, b, cell.volume);
    for (const CellRulePoint& point : cell_rule()) {
      const PathCoefficients here = paths.matter().at(cell.index, b, any, cell.position(point.barycentric));
      double light = 0;
      for (std::size_t i = 0; i < 4; ++i) light += point.barycentric[i] * fluence[i];
      const double measure = point.weight * cell.volume * light;
      moments.add(point.barycentric, measure, b, here.absorption, NodalMoments::absorbed);
      moments.add(point.barycentric, measure, b, here.scattering, NodalMoments::collided);
    }
  }
}

/// Which cells scatter by direction.
class DirectionalCells {
 public:
  explicit DirectionalCells(const LightPaths& paths) : paths_(paths), phases_(paths.problem()) {}

  bool has(CellIndex cell) const {
    return scatters_by_direction(paths_.problem(), phases_, paths_.matter(), cell);
  }
  bool any() const {
    for (std::int32_t c = 0; c < paths_.problem().mesh().cell_count(); ++c)
      if (has(CellIndex(c))) return true;
    return false;
  }
  /// Lets moments of a cell know what scatters by direction, where that is asked for.
  void prepare(CellIndex cell, const CollisionField& field, AngularDetail detail,
               NodalMoments& moments) const {
    if (!field.empty() && has(cell))
      moments.keep_directions(field.directions(), detail);
    else
      moments.leave_out_directions();
  }

 private:
  const LightPaths& paths_;
  PhaseList phases_;
};

std::shared_ptr<const IncidentDirections> incident_directions(const LightPaths& paths,
                                                              const SourceViews& sources) {
  std::vector<Vec3> beams;
  for (const LightSource* source : sources)
    if (const BeamSource* beam = source->as_beam())
      beams.insert(beams.end(), beam->directions().begin(), beam->directions().end());
  return std::make_shared<const IncidentDirections>(paths.problem(), beams);
}

/// [4][band] integrals over a cell of all that scatters of a light with an extent.
std::vector<double> scattered_power(const LightPaths& paths, const LitCell& cell,
                                    const NodalMoments& moments) {
  const RayMatter& matter = paths.matter();
  const bool uneven =
      !matter.empty() &&
      (matter.varies(cell.index) || matter.depends_on_direction(paths.problem().mesh().region(cell.index)));
  const RayMatter::View any;  // asked only where directions are alike
  std::vector<double> power;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t b = 0; b < paths.bands(); ++b)
      power.push_back(uneven ? moments.at(i, NodalMoments::collided, b)
                             : moments.at(i, 0, b) * matter.at(cell.index, b, any).scattering);
  return power;
}

/// Adds the integrals over a cell to the field.
void add_moments(const LightPaths& paths, const LitCell& cell, const NodalMoments& moments,
                 UncollidedField& field) {
  const std::size_t bands = paths.bands();
  const RayMatter& matter = paths.matter();
  const bool uneven =
      !matter.empty() &&
      (matter.varies(cell.index) || matter.depends_on_direction(paths.problem().mesh().region(cell.index)));
  const RayMatter::View any;  // asked only where directions are alike
  const CellField fluences(field.fluence, bands), collided(field.collided, bands);
  const CellVectors net_flux(field.net_flux, bands);
  const BandTable absorbed(field.absorbed, bands);
  for (std::size_t b = 0; b < bands; ++b) {
    const PathCoefficients here =
        matter.empty() || uneven ? PathCoefficients{} : matter.at(cell.index, b, any);
    for (std::size_t i = 0; i < 4; ++i) {
      const double fluence = moments.nodal(i, 0, b, cell.volume);
      fluences(cell.index, i, b) += fluence;
      for (std::size_t axis = 0; axis < 3; ++axis)
        net_flux(cell.index, i, axis, b) += moments.nodal(i, 1 + axis, b, cell.volume);
      if (matter.empty()) continue;
      collided(cell.index, i, b) +=
          uneven ? moments.nodal(i, NodalMoments::collided, b, cell.volume) : here.scattering * fluence;
      absorbed(cell.index, b) +=
          uneven ? moments.at(i, NodalMoments::absorbed, b) / cell.volume : here.absorption * fluence / 4;
    }
  }
  if (moments.by_direction() != nullptr)
    field.collisions.add(cell.index, cell.volume, *moments.by_direction());
}

/// What a thread works with.
struct Workspace {
  LightBeams beams;
  NodalMoments moments;
};

void add_cells(const LightPaths& paths, const LightSource& source, const ShadowPlanes& shadows,
               const std::optional<ExtendedLight>& extended, const RankShare& own, int threads,
               StageCounter& counter, UncollidedField& field) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const RayMatter& matter = paths.matter();
  const DirectionalCells directional(paths);
  const auto add_cell = [&](std::size_t c, Workspace& work) {
    if (!own.has(c)) return counter.add();
    const LitCell cell(paths, CellIndex(static_cast<std::int64_t>(c)));
    NodalMoments& moments = work.moments;
    moments.clear();
    if (!extended) {
      directional.prepare(cell.index, field.collisions, AngularDetail::fine, moments);
      add_directly(paths, source, shadows, cell, work.beams, moments);
    } else {
      moments.leave_out_directions();
      extended->add(cell, work.beams, moments);
      if (!matter.empty() && matter.depends_on_direction(mesh.region(cell.index)))
        add_directional_losses(paths, source, cell, work.beams, moments);
      else if (matter.varies(cell.index))
        add_varying_losses(paths, cell, moments);
      directional.prepare(cell.index, field.collisions, AngularDetail::medium, moments);
      if (moments.by_direction() != nullptr)
        add_extended_collisions(paths, source, cell, scattered_power(paths, cell, moments), work.beams,
                                *moments.by_direction());
    }
    add_moments(paths, cell, moments, field);
    return counter.add();
  };
  parallel_for(
      static_cast<std::size_t>(mesh.cell_count()), threads, 64,
      [&] {
        return Workspace{LightBeams(paths.bands()), NodalMoments(4, matter.empty() ? 4 : 6, paths.bands())};
      },
      add_cell);
}

void add_walls(const LightPaths& paths, const LightSource& source, const ShadowPlanes& shadows,
               const std::optional<ExtendedLight>& extended, const RankShare& own, int threads,
               StageCounter& counter, std::vector<double>& irradiance) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  const std::size_t bands = paths.bands();
  const auto add_face = [&](std::size_t f, Workspace& work) {
    if (!own.has(f)) return counter.add();
    const FaceIndex face(static_cast<std::int64_t>(f));
    NodalMoments& moments = work.moments;
    moments.clear();
    if (extended)
      extended->add(face, work.beams, moments);
    else
      add_irradiance(paths, source, shadows, face, work.beams, moments);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t b = 0; b < bands; ++b)
        FaceField(irradiance, bands)(face, i, b) += moments.nodal(i, 0, b, mesh.area(face));
    return counter.add();
  };
  parallel_for(
      static_cast<std::size_t>(mesh.boundary_face_count()), threads, 64,
      [&] {
        return Workspace{LightBeams(bands), NodalMoments(3, 1, bands)};
      },
      add_face);
}

/// How often cells, faces and vertices are visited for all sources.
std::size_t visits(const TetrahedralMesh& mesh, const SourceViews& sources) {
  std::size_t count = 0;
  for (const auto& source : sources) {
    const WideSource* wide = source->as_wide();
    const SkySource* sky = wide != nullptr ? wide->as_sky() : nullptr;
    count += sky != nullptr ? sky_visits(mesh, *sky) : static_cast<std::size_t>(mesh.cell_count());
    count += static_cast<std::size_t>(mesh.boundary_face_count());
  }
  return count;
}

UncollidedField dark_field(const LightPaths& paths) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  UncollidedField field;
  field.fluence.assign(static_cast<std::size_t>(mesh.cell_count()) * 4 * paths.bands(), 0);
  field.net_flux.assign(3 * field.fluence.size(), 0);
  field.irradiance.assign(static_cast<std::size_t>(mesh.boundary_face_count()) * 3 * paths.bands(), 0);
  if (paths.matter().empty()) return field;
  field.collided.assign(field.fluence.size(), 0);
  field.absorbed.assign(static_cast<std::size_t>(mesh.cell_count()) * paths.bands(), 0);
  return field;
}

/// Brings the cells and faces of each rank to all.
void share(UncollidedField& field, RankGroup& ranks) {
  for (std::vector<double>* values :
       {&field.fluence, &field.net_flux, &field.irradiance, &field.collided, &field.absorbed})
    ranks.merge(*values);
  field.collisions.share(ranks);
}

}  // namespace

double scattered_density(const Problem& problem, const UncollidedField& field, std::size_t entry) {
  if (!field.collided.empty()) return field.collided[entry];
  const auto bands = static_cast<std::size_t>(problem.band_count());
  return problem.scattering()[entry / (4 * bands) * bands + entry % bands] * field.fluence[entry];
}

UncollidedField uncollided_field(const LightPaths& paths, const SourceViews& sources,
                                 std::shared_ptr<const IncidentDirections> incident, int threads,
                                 const StageObserver& observer, RankGroup* ranks) {
  UncollidedField field = dark_field(paths);
  const DirectionalCells directional(paths);
  if (!sources.empty() && directional.any())
    field.collisions = {incident ? std::move(incident) : incident_directions(paths, sources),
                        static_cast<std::size_t>(paths.problem().mesh().cell_count()), paths.bands()};
  const std::vector<ShadowEdge> shadow_edges = shadow_edges_of(paths);
  const RankShare own(ranks);
  StageCounter counter(visits(paths.problem().mesh(), sources), observer);
  for (const LightSource* source : sources) {
    if (counter.stopped()) break;
    const WideSource* wide = source->as_wide();
    std::optional<ExtendedLight> extended;
    if (wide != nullptr && wide->as_extended() != nullptr)
      extended.emplace(paths, *wide->as_extended(), shadow_edges, threads, ranks);
    const ShadowPlanes planes(paths, shadow_edges, *source);
    if (wide != nullptr && wide->as_sky() != nullptr)
      add_sky_light(
          paths, *wide->as_sky(), own, threads, counter,
          [&](const LitCell& cell, NodalMoments& moments) {
            directional.prepare(cell.index, field.collisions, AngularDetail::coarse, moments);
          },
          [&](const LitCell& cell, const NodalMoments& moments) {
            add_moments(paths, cell, moments, field);
          });
    else
      add_cells(paths, *source, planes, extended, own, threads, counter, field);
    if (counter.stopped()) break;
    add_walls(paths, *source, planes, extended, own, threads, counter, field.irradiance);
  }
  if (ranks != nullptr) share(field, *ranks);
  return field;
}

UncollidedField uncollided_field(const LightPaths& paths, const LightSources& sources, int threads,
                                 const StageObserver& observer, RankGroup* ranks) {
  SourceViews views;
  for (const auto& source : sources) views.push_back(source.get());
  bool stopped = false;
  const StageObserver noting = [&](double share) {
    stopped = observer && !observer(share);
    return !stopped;
  };
  UncollidedField field = uncollided_field(paths, views, nullptr, threads, noting, ranks);
  if (!stopped) field.glossy = GlossyBeams(paths, sources, threads);
  return field;
}

}  // namespace etendue
