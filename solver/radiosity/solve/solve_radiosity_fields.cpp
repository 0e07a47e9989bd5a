// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What a solution by radiosity brings to walls and into the domain.
#include <algorithm>
#include <numbers>

#include "mesh/tetrahedra/corners.h"
#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/radiosity/solve/solve_radiosity.h"

namespace etendue {
namespace {

using std::numbers::pi;

// Four points of degree 2 in a tetrahedron (Keast 1986, rule 2): weights 1/4, this near to a vertex each.
constexpr double near_share = 0.585410196624968515, far_share = 0.138196601125010504;

}  // namespace

void RadiosityRoom::fields_on_walls(const RadiosityState& state, Solution& fields) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto faces = static_cast<std::size_t>(mesh.boundary_face_count());
  fields.irradiance.assign(faces * 3 * bands_, 0);
  fields.exitance.assign(faces * 3 * bands_, 0);
  fields.half_range.assign(faces, pi);
  const std::vector<std::int32_t> behind = faces_behind(mesh);
  const auto mean_on = [&](const std::vector<double>& values, std::size_t face, std::size_t band) {
    double mean = 0;
    for (const FacePart& part : patches_.of_faces[face])
      mean += part.share * values[part.patch * bands_ + band];
    return mean;
  };
  for (std::size_t f = 0; f < faces; ++f) {
    const Wall& wall = problem_.wall(mesh.wall(FaceIndex(static_cast<std::int64_t>(f))));
    for (std::size_t b = 0; b < bands_; ++b) {
      const double mean = mean_on(state.irradiance, f, b);
      double sent = pi * wall.radiance[b] + wall.diffuse[b] * mean;
      if (wall.transmitted(b) > 0)
        sent += wall.transmitted(b) * mean_on(state.irradiance, static_cast<std::size_t>(behind[f]), b);
      if (!state.redirected.empty()) sent += mean_on(state.redirected, f, b);
      for (std::size_t node = 3 * f; node < 3 * f + 3; ++node) {
        fields.irradiance[node * bands_ + b] = mean;
        fields.exitance[node * bands_ + b] = sent;
      }
    }
  }
}

WallLightField RadiosityRoom::light(int rays, int path_rays) const {
  WallLightField field(*exchange_, exitance_, bands_, rays);
  if (extended_ != nullptr) field.look_along(extended_->paths(), path_rays);
  return field;
}

// What comes from these walls as lights are followed along rays: straight, and via mirrors, but not of
// glossy walls. H_j = sum over k of G_jk E_k / A_j.
std::vector<double> RadiosityRoom::irradiance_by_rays(const std::vector<bool>& walls) const {
  std::vector<double> emission = equation().emission;
  for (std::size_t i = 0; i < emission.size(); ++i)
    if (!walls[static_cast<std::size_t>(patches_.walls[i / bands_])]) emission[i] = 0;
  std::vector<double> irradiance;
  if (extended_ == nullptr) {
    irradiance = exchange_->times(emission, bands_);
  } else {
    ExtendedExchange mirrored(*exchange_, problem_, patches_, Redirection::mirrors_alone, options_.path_rays);
    mirrored.close_as(*extended_);
    irradiance = mirrored.times(emission);
  }
  for (std::size_t i = 0; i < irradiance.size(); ++i)
    irradiance[i] /= exchange_->patches()[i / bands_].area();
  return irradiance;
}

SavedState RadiosityRoom::state(const std::vector<bool>& followed, std::span<const double> half_range) const {
  std::vector<double> rest = solved_.irradiance;
  if (std::ranges::count(followed, true) > 0) {
    const std::vector<double> straight = irradiance_by_rays(followed);
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= straight[i];
  }
  SavedState state;
  state.bands = static_cast<int>(bands_);
  state.fluence.assign(static_cast<std::size_t>(problem_.mesh().cell_count()) * 4 * bands_, 0);
  state.irradiance = means_at_vertices(problem_.mesh(), patches_, rest, bands_);
  for (std::size_t i = 0; i < state.irradiance.size(); ++i)
    state.irradiance[i] *= half_range[i / (3 * bands_)] / pi;
  return state;
}

// The P1 field that takes the values at the four points of the rule: the projection on P1 by that rule.
void RadiosityRoom::fill_cells(Solution& fields, const FactorProgress& progress) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  fields.fluence.assign(cells * 4 * bands_, 0);
  fields.net_flux.assign(cells * 12 * bands_, 0);
  const WallLightField field = light(1, options_.path_rays);
  const auto fill = [&](std::size_t c) {
    const std::array<Vec3, 4> corners = corners_of(mesh, CellIndex(static_cast<std::int64_t>(c)));
    double* fluence = fields.fluence.data() + c * 4 * bands_;
    double* net_flux = fields.net_flux.data() + c * 12 * bands_;
    for (std::size_t i = 0; i < 4; ++i) {
      Vec3 point = Vec3::Zero();
      for (std::size_t k = 0; k < 4; ++k) point += (k == i ? near_share : far_share) * corners[k];
      field.add_at(point, {fluence + i * bands_, bands_}, {net_flux + i * 3 * bands_, 3 * bands_});
    }
    const auto to_vertices = [](double* values, std::size_t count) {
      for (std::size_t v = 0; v < count; ++v) {
        const double sum = values[v] + values[count + v] + values[2 * count + v] + values[3 * count + v];
        for (std::size_t i = 0; i < 4; ++i)
          values[i * count + v] = (values[i * count + v] - far_share * sum) / (near_share - far_share);
      }
    };
    to_vertices(fluence, bands_);
    to_vertices(net_flux, 3 * bands_);
  };
  const std::size_t step = cells / progress_steps + 1;
  for (std::size_t begin = 0; begin < cells; begin += step) {
    const std::size_t end = std::min(cells, begin + step);
#pragma omp parallel for schedule(dynamic, 4) num_threads(options_.threads)
    for (std::size_t c = begin; c < end; ++c) fill(c);
    if (progress) progress(static_cast<double>(end) / static_cast<double>(cells));
  }
}

}  // namespace etendue
