// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/photon_mesh.h"

#include <algorithm>
#include <cmath>

#include "mesh/tetrahedra/corners.h"
#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/problem/mirror.h"
#include "solver/problem/problem_checks.h"

namespace etendue {
namespace {

/// A unit vector in the wall, level where the wall stands upright.
Vec3 tangent_of(const Vec3& normal) {
  const Vec3 level = Vec3::UnitZ().cross(normal);
  return level.norm() > 1e-6 ? level.normalized() : Vec3(normal.unitOrthogonal());
}

// A free path that no domain is as wide as [length].
constexpr double no_collision = 1e290;

void copy(const Vec3& from, double (&to)[3]) { std::copy(from.begin(), from.end(), to); }

}  // namespace

double sampled_cosine(const PhaseSampler& sampler, double u) { return sampler.cosine(u); }

double glossy_albedo(const Reflectance& glossy, double cos_in) { return glossy.albedo(cos_in); }

double part_mirrored(double cos_in, double refractive_index) {
  return fresnel_reflectance(std::max(0.0, cos_in), refractive_index);
}

double reflect_glossily(const Reflectance& glossy, const double (&n)[3], double u, double v, double (&w)[3]) {
  const Vec3 normal(n[0], n[1], n[2]), light(-w[0], -w[1], -w[2]);
  const double cos_in = std::min(1.0, light.dot(normal));
  if (cos_in <= 0) return 0;
  const ReflectedRay ray = glossy.sample(cos_in, u, v);
  copy(from_frame(ray.direction, light, normal), w);
  return ray.weight;
}

PhotonMesh::PhotonMesh(const Problem& problem, const DirectionalInput& input, int band)
    : in_plane_(problem.space() == AngularSpace::plane), by_direction_(!input.empty()) {
  add_cells(problem, band);
  add_faces(problem, input.emission, band);
  add_deflections(problem, input, band);
}

// The gradient of coordinate i is -(area normal of face i out of the cell) / (3 V).
void PhotonMesh::add_cells(const Problem& problem, int band) {
  const TetrahedralMesh& mesh = problem.mesh();
  cells_.resize(static_cast<std::size_t>(mesh.cell_count()));
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex index(c);
    PhotonCell& cell = cells_[index.at()];
    for (std::size_t i = 0; i < 4; ++i) {
      const FaceIndex face(mesh.faces(index)[i]);
      const bool owned = mesh.owner(face) == index;
      const Vec3 gradient = (owned ? -1.0 : 1.0) / (3 * mesh.volume(index)) * mesh.area_normal(face);
      cell.gx[i] = gradient.x();
      cell.gy[i] = gradient.y();
      cell.gz[i] = gradient.z();
      cell.offset[i] = -gradient.dot(corner_of(mesh, index, i == 0 ? 1 : 0));
      if (face.value() < mesh.boundary_face_count()) {
        cell.across[i] = -1 - face.value();
        continue;
      }
      const CellIndex other = owned ? mesh.neighbour(face) : mesh.owner(face);
      const auto& beyond = mesh.faces(other);
      const auto local = std::find(beyond.begin(), beyond.end(), face.value()) - beyond.begin();
      cell.across[i] = 4 * other.value() + static_cast<std::int32_t>(local);
    }
    cell.scattering = problem.scattering(index, band);
    cell.free_path = cell.scattering > 0 ? 1 / cell.scattering : no_collision;
    cell.absorption = problem.absorption(index, band);
    cell.emission = problem.emission(index, band);
    for (std::size_t i = 0; i < 3; ++i)
      cell.slope[i] =
          static_cast<float>(problem.cell_emission().slope(index, static_cast<std::size_t>(band), i + 1));
    cell.deflection = mesh.region(index);
  }
}

void PhotonMesh::add_faces(const Problem& problem, const FormulaEmission& emission, int band) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto b = static_cast<std::size_t>(band);
  const std::vector<std::int32_t> behind = faces_behind(mesh);
  faces_.resize(static_cast<std::size_t>(mesh.boundary_face_count()));
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex index(f);
    PhotonFace& face = faces_[index.at()];
    const Wall& wall = problem.wall(mesh.wall(index));
    const Vec3 normal = -mesh.area_normal(index).normalized();
    copy(normal, face.normal);
    copy(tangent_of(normal), face.tangent);
    face.diffuse = wall.diffuse[b];
    face.specular = wall.specular[b];
    face.transmittance = wall.transmitted(b);
    face.glossy = wall.glossy_in(b);
    face.behind = behind[index.at()];
    face.sent = emission.of_wall(mesh.wall(index), band);
    face.radiance = wall.radiance[b];
    face.refractive_index = wall.refractive_index;
    face.cell = mesh.owner(index).value();
    const auto& faces = mesh.faces(mesh.owner(index));
    face.local = static_cast<std::int32_t>(std::find(faces.begin(), faces.end(), f) - faces.begin());
    // Vertices are sorted in faces as in cells.
    for (std::int32_t i = 0; i < 3; ++i) face.corner[i] = i + (i >= face.local ? 1 : 0);
  }
}

void PhotonMesh::add_deflections(const Problem& problem, const DirectionalInput& input, int band) {
  const PhaseList phases(problem);
  for (const PhaseFunction& phase : phases.phases())
    samplers_.push_back(std::make_unique<PhaseSampler>(phase));
  for (int region = 0; region < static_cast<int>(problem.media().size()); ++region) {
    Deflection how;
    how.emitter = input.emission.of_region(region, band);
    how.medium = input.media.of(region, band);
    how.turns_by_direction = how.medium != nullptr && how.medium->sampler() != nullptr;
    const int number = phases.of(region, static_cast<std::size_t>(band));
    if (number < 0) {
      deflections_.push_back(how);
      continue;
    }
    const auto at = static_cast<std::size_t>(number);
    if (const auto* hg = std::get_if<PhaseHenyeyGreenstein>(&phases.phases()[at])) {
      how.kind = Deflection::Kind::henyey_greenstein;
      how.asymmetry = hg->asymmetry;
      how.half_inverse = hg->asymmetry != 0 ? 1 / (2 * hg->asymmetry) : 0;
    } else {
      how.kind = Deflection::Kind::sampled;
      how.sampler = samplers_[at].get();
    }
    deflections_.push_back(how);
  }
}

double PhotonMesh::distance_through(CellIndex index, const Vec3& x, const Vec3& w) const {
  const PhotonCell& cell = cells_[index.at()];
  double path_length = HUGE_VAL;
  for (int i = 0; i < 4; ++i) {
    const double rate = cell.gx[i] * w.x() + cell.gy[i] * w.y() + cell.gz[i] * w.z();
    const double at = cell.gx[i] * x.x() + cell.gy[i] * x.y() + cell.gz[i] * x.z() + cell.offset[i];
    if (rate < 0) path_length = std::min(path_length, -at / rate);
  }
  return path_length;
}

void refuse_for_photons(const Problem& problem) {
  std::vector<Fault> faults;
  for (const Medium& medium : problem.media())
    if (std::ranges::any_of(medium.directional, [](const DirectionalScattering& scattering) {
          return std::holds_alternative<KernelMatrix>(scattering);
        }))
      faults.push_back(fault_at(origin_of(medium, "kernel"), "",
                                "is a matrix between the ordinates of a set, and photons have none; give a "
                                "formula, or use solve.method = \"auto\""));
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace etendue
