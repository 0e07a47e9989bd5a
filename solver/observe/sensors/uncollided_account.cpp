// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/uncollided_account.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "base/field_view.h"
#include "base/parallel/parallel_for.h"
#include "base/quadrature/cell_rule.h"
#include "base/quadrature/simplex_cubature.h"
#include "mesh/tetrahedra/corners.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/sources/point_source.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Of integrals over the cone of what a light sends.
constexpr double cone_tolerance = 1e-9;
constexpr int most_directions = 20000;

/// Of sums over a face or a cell: estimated error, and points of a light that is a single beam. Of wide
/// lights the edges of a cone lie elsewhere for each of many beams, so fewer will do.
constexpr double part_tolerance = 1e-3;
constexpr std::size_t most_points = 1000, most_beams = 4000;

bool cone_holds(const std::optional<Cone>& cone, const Vec3& travel) { return !cone || cone->holds(travel); }

/// Those of all lights but one.
LightBeams beams_at(const LightSetup& lights, const PointInCell& place,
                    const LightSource* without = nullptr) {
  LightBeams beams(lights.paths().bands());
  for (const auto& source : lights.sources())
    if (source.get() != without) source->add_beams(place, Sight::attenuated, fine_light, beams);
  return beams;
}

/// The light that a wall is; null where it is none. Walls are the last of the sources. Seen from its own
/// surface it is not known whether it shines, so there it is left out.
const LightSource* light_of_wall(const LightSetup& lights, int wall) {
  if (!lights.has_wall(wall)) return nullptr;
  const auto found =
      std::find_if(lights.sources().rbegin(), lights.sources().rend(),
                   [&](const auto& source) { return source->name() == lights.problem().wall(wall).name; });
  return found == lights.sources().rend() ? nullptr : found->get();
}

/// So many points that their beams are not too many.
SimplexEffort effort_at(const LightSetup& lights, const PointInCell& place) {
  const std::size_t beams = std::max<std::size_t>(1, beams_at(lights, place).size());
  return {part_tolerance, std::min(most_beams / beams, most_points)};
}

/// [band] the part of the fluence in a cell that travels within the cone.
std::vector<double> share_of(const LightSetup& lights, CellIndex cell, const Cone& cone) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const std::size_t bands = lights.paths().bands();
  const std::array<Vec3, 4> corners = corners_of(mesh, cell);
  const std::vector<double> sums = integrate_over_simplex(
      corners, 2 * bands,
      [&](const Vec3& point, std::span<double> values) {
        const LightBeams beams = beams_at(lights, {cell, point});
        for (std::size_t n = 0; n < beams.size(); ++n)
          for (std::size_t b = 0; b < bands; ++b) {
            values[b] += beams.fluence(n)[b];
            if (cone.holds(beams.direction(n))) values[bands + b] += beams.fluence(n)[b];
          }
      },
      effort_at(lights, {cell, mesh.centroid(cell)}));
  std::vector<double> share(bands, 0);
  for (std::size_t b = 0; b < bands; ++b) share[b] = sums[b] > 0 ? sums[bands + b] / sums[b] : 0;
  return share;
}

/// [band] what the light in a cell meets on its mean path, of what travels within the cone.
std::vector<PathCoefficients> coefficients_of(const LightSetup& lights, CellIndex cell,
                                              const std::optional<Cone>& cone) {
  const RayMatter& matter = lights.paths().matter();
  std::vector<PathCoefficients> mean(lights.paths().bands()), sum(mean);
  std::vector<double> light(mean.size(), 0);
  const RayMatter::View any = matter.view(Vec3::UnitZ());
  for (std::size_t b = 0; b < mean.size(); ++b) mean[b] = matter.at(cell, b, any);
  if (!matter.depends_on_direction(lights.problem().mesh().region(cell)) && !matter.varies(cell)) return mean;
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const std::array<Vec3, 4> corners = corners_of(mesh, cell);
  for (const CellRulePoint& node : cell_rule()) {
    const Vec3 point = point_at(node.barycentric, corners);
    const LightBeams beams = beams_at(lights, {cell, point});
    for (std::size_t n = 0; n < beams.size(); ++n) {
      if (!cone_holds(cone, beams.direction(n))) continue;
      const RayMatter::View view = matter.view(beams.direction(n));
      for (std::size_t b = 0; b < mean.size(); ++b) {
        const PathCoefficients here = matter.at(cell, b, view, point);
        const double fluence = node.weight * beams.fluence(n)[b];
        light[b] += fluence;
        sum[b].absorption += here.absorption * fluence;
        sum[b].scattering += here.scattering * fluence;
      }
    }
  }
  for (std::size_t b = 0; b < mean.size(); ++b)
    if (light[b] > 0) mean[b] = {sum[b].absorption / light[b], sum[b].scattering / light[b]};
  return mean;
}

void add_cell(const LightSetup& lights, const Solution& solution, CellIndex cell,
              const std::optional<Cone>& cone, RegionAccount& account) {
  const Problem& problem = lights.problem();
  const std::size_t bands = lights.paths().bands();
  const std::vector<double> share = cone ? share_of(lights, cell, *cone) : std::vector<double>(bands, 1);
  const std::vector<PathCoefficients> coefficients = coefficients_of(lights, cell, cone);
  for (std::size_t b = 0; b < bands; ++b) {
    const double fluence = ConstCellField(solution.lights.fluence, bands).mean(cell, b);
    const double path = problem.mesh().volume(cell) * fluence * share[b];
    account.path[b] += path;
    account.absorbed[b] += coefficients[b].absorption * path;
    account.scattered_out[b] += coefficients[b].scattering * path;
  }
}

/// Integral of max(0, n.w) over the cone, or over all directions [sr].
double projected(const std::optional<Cone>& cone, const Vec3& normal) {
  if (!cone) return pi;
  return integrate_over_cone(
             *cone, 1,
             [&](const Vec3& travel, std::span<double> value) {
               value[0] = std::max(0.0, normal.dot(travel));
             },
             cone_tolerance, most_directions)
      .values[0];
}

void add_face(const LightSetup& lights, const SurfaceFace& part, const std::optional<Cone>& cone,
              RegionAccount& account) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const std::size_t bands = account.path.size();
  const LightSource* own = part.outside ? nullptr : light_of_wall(lights, mesh.wall(part.face));
  std::vector<Vec3> corners;
  for (const std::int32_t v : mesh.vertices(part.face)) corners.push_back(mesh.point(VertexIndex(v)));
  const Vec3 outwards = part.area.normalized();
  // [out, in][band]
  const std::vector<double> flows = integrate_over_simplex(
      corners, 2 * bands,
      [&](const Vec3& point, std::span<double> values) {
        const LightBeams beams = beams_at(lights, {part.inside, point}, own);
        for (std::size_t n = 0; n < beams.size(); ++n) {
          if (!cone_holds(cone, beams.direction(n))) continue;
          const double across = outwards.dot(beams.direction(n));
          for (std::size_t b = 0; b < bands; ++b)
            values[(across > 0 ? 0 : bands) + b] += std::abs(across) * beams.fluence(n)[b];
        }
      },
      effort_at(lights, {part.inside, mesh.centroid(part.inside)}));
  for (std::size_t b = 0; b < bands; ++b) {
    account.flowing_out[b] += flows[b];
    account.flowing_in[b] += flows[bands + b];
  }
  if (own == nullptr) return;
  const double inwards = projected(cone, -part.area.normalized()) * part.area.norm();
  for (std::size_t b = 0; b < bands; ++b)
    account.flowing_in[b] += inwards * lights.problem().wall(mesh.wall(part.face)).radiance[b];
}

/// What lights in the region send.
class Emission {
 public:
  Emission(const LightSetup& lights, int region, const std::optional<Cone>& cone)
      : lights_(lights), mesh_(lights.problem().mesh()), locator_(mesh_), region_(region), cone_(cone) {}

  void add_to(RegionAccount& account) const {
    for (const Light& light : lights_.problem().lights())
      if (const auto* surface = std::get_if<SurfaceLight>(&light.kind);
          surface != nullptr && light.uncollided != Uncollided::no)
        add_surface(*surface, account);
    for (const auto& source : lights_.sources())
      if (const PointSource* point = source->as_point(); point != nullptr && is_here(point->position()))
        add_point(*point, account);
    if (!lights_.has_region(region_)) return;
    const double solid_angle = cone_ ? cone_->solid_angle() : 4 * pi;
    for (std::int32_t c = 0; c < mesh_.cell_count(); ++c)
      for (std::size_t b = 0; b < account.path.size() && mesh_.region(CellIndex(c)) == region_; ++b)
        account.emitted[b] += solid_angle * mesh_.volume(CellIndex(c)) *
                              lights_.problem().emission(CellIndex(c), static_cast<int>(b));
  }

 private:
  bool is_here(const Vec3& position) const {
    const std::vector<CellPoint> cells = locator_.find(position);
    return !cells.empty() && mesh_.region(cells.front().cell) == region_;
  }
  void add_surface(const SurfaceLight& light, RegionAccount& account) const {
    for (std::size_t i = 0; i + 2 < light.triangles.size(); i += 3) {
      const Vec3 &a = light.triangles[i], &b = light.triangles[i + 1], &c = light.triangles[i + 2];
      if (!is_here((a + b + c) / 3)) continue;
      const Vec3 area = (b - a).cross(c - a) / 2;
      const double spread = projected(cone_, area.normalized()) * area.norm();
      for (std::size_t n = 0; n < account.path.size(); ++n) account.emitted[n] += spread * light.radiance[n];
    }
  }
  void add_point(const PointSource& point, RegionAccount& account) const {
    const double part = !cone_ ? 1
                               : integrate_over_cone(
                                     *cone_, 1,
                                     [&](const Vec3& travel, std::span<double> value) {
                                       value[0] = point.intensity(point.images().front(), travel);
                                     },
                                     cone_tolerance, most_directions)
                                     .values[0];
    for (std::size_t b = 0; b < account.path.size(); ++b) account.emitted[b] += part * point.power()[b];
  }

  const LightSetup& lights_;
  const TetrahedralMesh& mesh_;
  CellLocator locator_;
  int region_;
  const std::optional<Cone>& cone_;
};

}  // namespace

RegionAccount uncollided_account(const LightSetup& lights, const Solution& solution,
                                 const AccountScope& scope, int threads, StageCounter* counter) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  RegionAccount account(lights.paths().bands());
  if (lights.empty()) return account;
  if (scope.region >= 0) Emission(lights, scope.region, scope.cone).add_to(account);
  std::vector<CellIndex> cells;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region(CellIndex(c)) == scope.region) cells.emplace_back(c);
  std::vector<RegionAccount> parts(cells.size() + scope.surface.size(), RegionAccount(account.path.size()));
  parallel_for(parts.size(), threads, 4, [&](std::size_t i) {
    if (i < cells.size())
      add_cell(lights, solution, cells[i], scope.cone, parts[i]);
    else
      add_face(lights, scope.surface[i - cells.size()], scope.cone, parts[i]);
    return counter == nullptr || counter->add();
  });
  for (const RegionAccount& part : parts) account.add(part, 1);
  return account;
}

std::size_t account_parts(const TetrahedralMesh& mesh, const AccountScope& scope) {
  return scope.surface.size() +
         static_cast<std::size_t>(std::ranges::count(mesh.cell_regions(), scope.region));
}

}  // namespace etendue
