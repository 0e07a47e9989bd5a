// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/walls/glossy_walls.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/transport/order/projected_area.h"
#include "solver/transport/order/sweep_order.h"
#include "solver/transport/walls/same_plane.h"

namespace etendue {
namespace {

/// A matrix that is wanted: of a wall and a band on a plane.
struct Plane {
  Vec3 normal;
  int wall;
};

/// The faces of glossy walls, and which plane each is on; f(face, plane, is_new).
template <class Function>
void for_glossy_faces(const Problem& problem, std::vector<Plane>& planes, const Function& f) {
  const TetrahedralMesh& mesh = problem.mesh();
  for (std::int32_t i = 0; i < mesh.boundary_face_count(); ++i) {
    const FaceIndex face(i);
    if (!problem.wall(mesh.wall(face)).is_glossy()) continue;
    const Vec3 normal = mesh.area_normal(face).normalized();
    const auto found = std::ranges::find_if(planes, [&](const Plane& plane) {
      return plane.wall == mesh.wall(face) && (plane.normal - normal).norm() < same_plane;
    });
    const auto at = static_cast<std::size_t>(found - planes.begin());
    const bool is_new = found == planes.end();
    if (is_new) planes.push_back({normal, mesh.wall(face)});
    f(face, at, is_new);
  }
}

/// Whether a band has another reflectance than those before.
bool is_another(const Wall& wall, std::size_t band) {
  return wall.glossy_in(band) != nullptr &&
         std::find(wall.glossy.begin(), wall.glossy.begin() + static_cast<std::ptrdiff_t>(band),
                   wall.glossy[band]) == wall.glossy.begin() + static_cast<std::ptrdiff_t>(band);
}

}  // namespace

GlossyWalls::GlossyWalls(const Problem& problem, const DirectionSet& directions, const WallSlots& wall_slots,
                         int stride, int face_nodes)
    : problem_(problem),
      directions_(directions),
      wall_slots_(wall_slots),
      stride_(static_cast<std::size_t>(stride)),
      face_length_(static_cast<std::size_t>(face_nodes) * stride_),
      row_size_(static_cast<std::size_t>(directions.count() / 2) * face_length_),
      place_of_(static_cast<std::size_t>(problem.mesh().boundary_face_count()), -1) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<Plane> planes;
  for_glossy_faces(problem, planes, [&](FaceIndex face, std::size_t plane, bool is_new) {
    const Wall& wall = problem.wall(mesh.wall(face));
    for (std::size_t b = 0; is_new && b < bands; ++b) {
      if (is_another(wall, b)) {
        matrices_.push_back(
            std::make_unique<WallMatrix>(directions, planes[plane].normal, *wall.glossy_in(b)));
        walls_of_matrices_.push_back(mesh.wall(face));
      }
      const auto first = std::ranges::find(wall.glossy, wall.glossy[b]) - wall.glossy.begin();
      const bool known = static_cast<std::size_t>(first) < b;
      matrix_of_.push_back(wall.glossy_in(b) == nullptr ? -1
                           : known ? matrix_of_[plane * bands + static_cast<std::size_t>(first)]
                                   : static_cast<std::int32_t>(matrices_.size()) - 1);
    }
    place_of_[face.at()] = static_cast<std::int32_t>(faces_.size());
    const bool is_mirror = std::ranges::any_of(wall.specular, [](double r) { return r > 0; });
    faces_.push_back({mesh.area_normal(face), face.value(), plane * bands, is_mirror});
  });
  reflected_ = AlignedArray(size());
}

void GlossyWalls::form(std::span<const double> arrived, int threads) {
  const Eigen::Index pairs = directions_.count() / 2;
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const auto nodes = static_cast<Eigen::Index>(face_length_ / stride_);
  using Step = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
  const Step step(static_cast<Eigen::Index>(face_length_), static_cast<Eigen::Index>(stride_));
  const auto count = static_cast<std::int64_t>(faces_.size());
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::int64_t f = 0; f < count; ++f)
    for (std::size_t b = 0; b < bands; ++b) {
      const std::int32_t matrix = matrix_of_[faces_[static_cast<std::size_t>(f)].first_matrix + b];
      if (matrix < 0) continue;
      const std::size_t first = static_cast<std::size_t>(f) * row_size_ + b;
      const Eigen::Map<const WallMatrix::Matrix, 0, Step> in(arrived.data() + first, pairs, nodes, step);
      Eigen::Map<WallMatrix::Matrix, 0, Step> out(reflected_.data() + first, pairs, nodes, step);
      out.noalias() = matrices_[static_cast<std::size_t>(matrix)]->entries() * in;
    }
}

template <class Real>
void GlossyWalls::add_reflected(OrdinateIndex m, std::span<const double> inflow,
                                const SweepSlotsOf<Real>& slots) const {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    if (projected_area(face.area_normal, directions_.direction(m)) >= 0) continue;
    Real* trace = slots.slot(wall_slots_.inflow(face.index));
    if (!face.is_mirror)
      std::copy_n(inflow.data() + static_cast<std::size_t>(face.index) * face_length_, face_length_, trace);
    const double* reflected = reflected_.data() + f * row_size_ + m.at() / 2 * face_length_;
    for (std::size_t i = 0; i < face_length_; ++i) trace[i] += reflected[i];
  }
}

template <class Real>
void GlossyWalls::store_arriving(OrdinateIndex m, const SweepSlotsOf<Real>& slots,
                                 std::span<double> arrived) const {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (projected_area(faces_[f].area_normal, directions_.direction(m)) <= 0) continue;
    double* kept = arrived.data() + f * row_size_ + m.at() / 2 * face_length_;
    for (std::size_t i = 0; i < face_length_; i += stride_)
      std::copy_n(slots.face_node(wall_slots_.inside(faces_[f].index), i / stride_), stride_, kept + i);
  }
}

double GlossyWalls::albedo(FaceIndex face, std::size_t band) const {
  const std::int32_t place = place_of_[face.at()];
  if (place < 0 || band >= static_cast<std::size_t>(problem_.band_count())) return 0;
  const std::int32_t matrix = matrix_of_[faces_[static_cast<std::size_t>(place)].first_matrix + band];
  return matrix < 0 ? 0 : matrices_[static_cast<std::size_t>(matrix)]->mean_albedo();
}

void GlossyWalls::add_arriving(FaceIndex face, std::size_t band, std::span<const double> radiance,
                               std::span<double> arrived) const {
  const std::int32_t place = place_of_[face.at()];
  if (place < 0) return;
  double* row = arrived.data() + static_cast<std::size_t>(place) * row_size_ + band;
  for (std::int32_t m = 0; m < directions_.count(); ++m) {
    if (projected_area(faces_[static_cast<std::size_t>(place)].area_normal,
                       directions_.direction(OrdinateIndex(m))) <= 0)
      continue;
    for (std::size_t i = 0; i < radiance.size(); ++i)
      row[static_cast<std::size_t>(m / 2) * face_length_ + i * stride_] += radiance[i];
  }
}

std::vector<std::string> GlossyWalls::notes() const {
  std::vector<std::string> notes;
  for (int w = 0; w < static_cast<int>(problem_.walls().size()); ++w) {
    RowSums all{HUGE_VAL, 0};
    std::size_t count = 0;
    for (std::size_t i = 0; i < matrices_.size(); ++i)
      if (walls_of_matrices_[i] == w) {
        all = {std::min(all.smallest, matrices_[i]->row_sums().smallest),
               std::max(all.largest, matrices_[i]->row_sums().largest)};
        ++count;
      }
    if (count > 0)
      notes.push_back(fmt::format(
          "wall {} reflects by {} {}: the set sees {:.3g} to {:.3g} of its albedo, "
          "scaled to 1",
          problem_.wall(w).name, count, count == 1 ? "matrix" : "matrices", all.smallest, all.largest));
  }
  return notes;
}

GlossyWalls::Size GlossyWalls::size_of(const Problem& problem, const DirectionSet& directions) {
  Size size;
  std::vector<Plane> planes;
  for_glossy_faces(problem, planes, [&](FaceIndex face, std::size_t, bool is_new) {
    size.faces += 1;
    const Wall& wall = problem.wall(problem.mesh().wall(face));
    for (std::size_t b = 0; is_new && b < static_cast<std::size_t>(problem.band_count()); ++b)
      if (is_another(wall, b)) size.matrices += WallMatrix::size(directions);
  });
  return size;
}

template void GlossyWalls::add_reflected(OrdinateIndex, std::span<const double>,
                                         const SweepSlotsOf<double>&) const;
template void GlossyWalls::store_arriving(OrdinateIndex, const SweepSlotsOf<double>&,
                                          std::span<double>) const;

template void GlossyWalls::add_reflected(OrdinateIndex, std::span<const double>,
                                         const SweepSlotsOf<float>&) const;
template void GlossyWalls::store_arriving(OrdinateIndex, const SweepSlotsOf<float>&, std::span<double>) const;

}  // namespace etendue
