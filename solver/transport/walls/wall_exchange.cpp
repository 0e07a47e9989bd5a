// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/walls/wall_exchange.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/angular/refraction/ordinate_reflectance.h"
#include "solver/problem/mirror.h"
#include "solver/transport/order/projected_area.h"
#include "solver/transport/order/sweep_order.h"

namespace etendue {
namespace {

/// Normals of one flat mirror differ by rounding only.
constexpr double same_plane = 1e-10;

std::vector<double> padded(std::span<const Wall> walls, std::vector<double> Wall::*values,
                           std::size_t stride) {
  std::vector<double> result(walls.size() * stride, 0);
  for (std::size_t w = 0; w < walls.size(); ++w)
    std::copy((walls[w].*values).begin(), (walls[w].*values).end(),
              result.begin() + static_cast<std::ptrdiff_t>(w * stride));
  return result;
}

/// Half ranges below this [sr] are those of walls that no direction reaches: the sides z = const in the
/// plane.
constexpr double out_of_reach = 1e-12;

bool any_positive(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v > 0; });
}

}  // namespace

WallExchange::WallExchange(const Problem& problem, const DirectionSet& directions,
                           const OrdinateSchedule& schedule, const WallSlots& wall_slots, int stride,
                           int face_nodes)
    : mesh_(problem.mesh()),
      problem_(problem),
      directions_(directions),
      wall_slots_(wall_slots),
      stride_(static_cast<std::size_t>(stride)),
      face_length_(static_cast<std::size_t>(face_nodes) * stride_),
      radiance_(padded(problem.walls(), &Wall::radiance, stride_)),
      diffuse_(padded(problem.walls(), &Wall::diffuse, stride_)),
      specular_(padded(problem.walls(), &Wall::specular, stride_)),
      transmitted_(padded(problem.walls(), &Wall::transmittance, stride_)),
      behind_(any_positive(transmitted_) ? faces_behind(mesh_) : std::vector<std::int32_t>()),
      glossy_(problem, directions, wall_slots, stride, face_nodes) {
  wall_reflects_.reserve(problem.walls().size());
  for (const Wall& wall : problem.walls()) {
    wall_reflects_.push_back(any_positive(wall.diffuse) || is_mirror(wall) || wall.is_glossy() ||
                             wall.transmits());
  }
  half_range_.resize(static_cast<std::size_t>(mesh_.boundary_face_count()));
  for (std::int32_t f = 0; f < mesh_.boundary_face_count(); ++f) {
    half_range_[static_cast<std::size_t>(f)] =
        directions.half_range(mesh_.area_normal(FaceIndex(f)).normalized());
  }
  for (std::size_t w = 0; w < problem.walls().size(); ++w)
    for (std::size_t b = 0; b < stride_; ++b)
      radiance_[w * stride_ + b] *= std::pow(problem.walls()[w].refractive_index, 2);
  find_mirrors(schedule);
  for (std::int32_t f = 0; f < mesh_.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const double range = half_range_[face.at()];
    faces_.push_back({mesh_.area_normal(face), 1 / mesh_.area(face), range > out_of_reach ? 1 / range : 0,
                      static_cast<std::size_t>(mesh_.wall(face))});
    all_.push_back(f);
    if (reflects(face)) reflecting_.push_back(f);
    if (mirror(face) != nullptr) mirror_faces_.push_back(f);
    for (std::size_t band = 0; band < stride_; ++band)
      feeds_back_ = feeds_back_ || (range > out_of_reach && fed_back(face, band) > 0) ||
                    transmitted_[faces_.back().wall * stride_ + band] > 0;
  }
  // Faces through which light leaves in the same directions are neighbors in the list, which helps branch
  // prediction.
  for (std::vector<std::int32_t>* list : {&all_, &reflecting_})
    std::stable_sort(list->begin(), list->end(), [this](std::int32_t a, std::int32_t b) {
      const Face &left = faces_[static_cast<std::size_t>(a)], &right = faces_[static_cast<std::size_t>(b)];
      return std::pair(octant(left.area_normal), left.wall) <
             std::pair(octant(right.area_normal), right.wall);
    });
}

void WallExchange::find_mirrors(const OrdinateSchedule& schedule) {
  mirror_of_.assign(half_range_.size(), -1);
  std::vector<Fault> faults;
  std::vector<char> refused(wall_reflects_.size(), 0);
  for (std::int32_t f = 0; f < mesh_.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const auto wall = static_cast<std::size_t>(mesh_.wall(face));
    if (half_range_[face.at()] <= out_of_reach) continue;
    if (refused[wall] || !is_mirror(problem_.wall(mesh_.wall(face)))) continue;
    const Vec3 normal = mesh_.area_normal(face).normalized();
    std::size_t plane = 0;
    const double index = problem_.walls()[wall].refractive_index;
    while (plane < planes_.size() &&
           ((planes_[plane].normal - normal).norm() > same_plane || planes_[plane].refractive_index != index))
      ++plane;
    if (plane == planes_.size()) {
      planes_.push_back(mirror_plane(face, schedule));
      if (std::count(planes_.back().partner.begin(), planes_.back().partner.end(), -1) > 0) {
        planes_.pop_back();
        refused[wall] = 1;
        const Wall& mirror = problem_.wall(mesh_.wall(face));
        Origin origin = mirror.origin;
        origin.key += mirror.refractive_index != 1 ? ".refractive_index" : ".specular";
        const Vec3 at = mesh_.centroid(face);
        faults.push_back(fault_at(
            origin, "",
            fmt::format(
                "the mirror at ({:.6g}, {:.6g}, {:.6g}) with normal ({:.6g}, {:.6g}, {:.6g}) takes ordinates "
                "out of the {} set of order {} (a mirrored ordinate must be in it); use mirrors on planes "
                "across x, y or z with a set that is neither rotated nor refined, or diffuse reflectance",
                at.x(), at.y(), at.z(), normal.x(), normal.y(), normal.z(), directions_.name(),
                directions_.order())));
        continue;
      }
    }
    mirror_of_[face.at()] = static_cast<std::int32_t>(mirrors_.size());
    mirrors_.push_back({plane, rows_[static_cast<std::size_t>(planes_[plane].pass)]++});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

WallExchange::MirrorPlane WallExchange::mirror_plane(FaceIndex face, const OrdinateSchedule& schedule) const {
  const Vec3 normal = mesh_.area_normal(face).normalized();
  const Wall& wall = problem_.wall(mesh_.wall(face));
  MirrorPlane plane{
      normal,
      wall.refractive_index,
      schedule.knows_reflections(normal) ? ReflectionPass::this_sweep : ReflectionPass::next_sweep,
      {},
      {}};
  for (std::int32_t m = 0; m < directions_.count(); ++m)
    plane.partner.push_back(directions_.mirrored(OrdinateIndex(m), normal));
  if (wall.refractive_index != 1) plane.reflected = ordinate_reflectances(directions_, wall, normal);
  return plane;
}

std::vector<double> WallExchange::emission_range() const {
  std::vector<double> range = half_range_;
  for (const std::int32_t f : mirror_faces_) {
    const MirrorPlane& plane = planes_[mirror(FaceIndex(f))->plane];
    if (plane.reflected.empty()) continue;
    double sum = 0;
    for (std::int32_t m = 0; m < directions_.count(); ++m)
      sum += directions_.weight(OrdinateIndex(m)) * (1 - plane.reflected[static_cast<std::size_t>(m)]) *
             std::max(0.0, -plane.normal.dot(directions_.direction(OrdinateIndex(m))));
    range[static_cast<std::size_t>(f)] = std::pow(plane.refractive_index, 2) * sum;
  }
  return range;
}

std::size_t WallExchange::irradiance_size() const { return half_range_.size() * face_length_; }

std::size_t WallExchange::row_size() const {
  return static_cast<std::size_t>(directions_.count() / 2) * face_length_;
}

double WallExchange::fed_back(FaceIndex face, std::size_t band) const {
  const int wall = mesh_.wall(face);
  const Mirror* of = mirror(face);
  const bool reflects_later = of != nullptr && planes_[of->plane].pass == ReflectionPass::next_sweep;
  return std::min(1.0, diffuse_[static_cast<std::size_t>(wall) * stride_ + band] +
                           (reflects_later ? mirrored_part_of_isotropic(problem_.wall(wall), band) : 0) +
                           glossy_.albedo(face, band));
}

// One of the two ordinates of a pair leaves through a face, so the number of the pair is enough. The radiance
// at glossy walls is stored before that at the mirrors of the next sweep.
std::size_t WallExchange::mirror_at(std::size_t row, std::int32_t ordinate) const {
  return row * row_size() + static_cast<std::size_t>(ordinate / 2) * face_length_;
}

void WallExchange::form_inflow(const TransportState& last, Emission emission, int threads,
                               std::span<double> inflow) {
  glossy_.form(last.mirrors().first(glossy_.size()), threads);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const std::size_t wall = faces_[f].wall * stride_;
    const double* irradiance = last.irradiance().data() + f * face_length_;
    double* own = inflow.data() + f * face_length_;
    for (std::size_t i = 0; i < face_length_; ++i) {
      const double sent = emission == Emission::included ? radiance_[wall + i % stride_] : 0;
      own[i] = sent + diffuse_[wall + i % stride_] * faces_[f].by_half_range * irradiance[i];
    }
  }
  // Both sides of a sheet have the same half range and the same nodes.
  for (std::size_t f = 0; f < behind_.size(); ++f) {
    if (behind_[f] < 0) continue;
    const double* irradiance = last.irradiance().data() + static_cast<std::size_t>(behind_[f]) * face_length_;
    for (std::size_t i = 0; i < face_length_; ++i)
      inflow[f * face_length_ + i] +=
          transmitted_[faces_[f].wall * stride_ + i % stride_] * faces_[f].by_half_range * irradiance[i];
  }
}

template <class Real>
void WallExchange::fill(std::span<const double> inflow, const SweepSlotsOf<Real>& slots) const {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const double* own = inflow.data() + f * face_length_;
    std::copy(own, own + face_length_, slots.slot(wall_slots_.inflow(static_cast<std::int32_t>(f))));
  }
}

template <class Real>
void WallExchange::reflect(OrdinateIndex m, const TransportState& last, std::span<const double> passing,
                           std::span<const double> inflow, const SweepSlotsOf<Real>& slots) const {
  for (const std::int32_t f : mirror_faces_) {
    const Face& face = faces_[static_cast<std::size_t>(f)];
    if (projected_area(face.area_normal, directions_.direction(m)) >= 0) continue;
    const Mirror& by = *mirror(FaceIndex(f));
    const MirrorPlane& plane = planes_[by.plane];
    const std::span<const double> from =
        plane.pass == ReflectionPass::this_sweep ? passing : last.mirrors().subspan(glossy_.size());
    const double* mirrored = from.data() + mirror_at(by.row, plane.partner[m.at()]);
    const double* own = inflow.data() + static_cast<std::size_t>(f) * face_length_;
    Real* trace = slots.slot(wall_slots_.inflow(f));
    if (!plane.reflected.empty()) {
      const double part = plane.reflected[m.at()];
      for (std::size_t i = 0; i < face_length_; ++i) trace[i] = (1 - part) * own[i] + part * mirrored[i];
      continue;
    }
    for (std::size_t i = 0; i < face_length_; ++i)
      trace[i] = own[i] + specular_[face.wall * stride_ + i % stride_] * mirrored[i];
  }
  glossy_.add_reflected(m, inflow, slots);
}

template <class Real>
void WallExchange::add_exitance(OrdinateIndex m, const SweepSlotsOf<Real>& slots,
                                std::span<double> exitance) const {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const double seen = projected_area(faces_[f].area_normal, directions_.direction(m));
    if (seen >= 0) continue;
    const double factor = -seen * faces_[f].by_area * directions_.weight(m);
    const Real* trace = slots.slot(wall_slots_.inflow(static_cast<std::int32_t>(f)));
    for (std::size_t i = 0; i < face_length_; ++i) exitance[f * face_length_ + i] += factor * trace[i];
  }
}

template <class Real>
void WallExchange::accumulate_irradiance(OrdinateIndex m, const SweepSlotsOf<Real>& slots, AccumulateAt what,
                                         std::span<double> irradiance, std::span<double> mirrors,
                                         std::span<double> passing) const {
  const std::span<const std::int32_t> faces = what == AccumulateAt::all ? all_ : reflecting_;
  if (stride_ == 1 && face_length_ == 3) {
    add_irradiance<1, Real>(m, slots, faces, irradiance);
  } else {
    add_irradiance<0, Real>(m, slots, faces, irradiance);
  }
  for (const std::int32_t f : mirror_faces_) {
    if (projected_area(faces_[static_cast<std::size_t>(f)].area_normal, directions_.direction(m)) <= 0)
      continue;
    const Mirror& by = *mirror(FaceIndex(f));
    const std::span<double> to =
        planes_[by.plane].pass == ReflectionPass::this_sweep ? passing : mirrors.subspan(glossy_.size());
    double* kept = to.data() + mirror_at(by.row, m.value());
    for (std::size_t i = 0; i < face_length_; i += stride_) {
      const Real* trace = slots.face_node(wall_slots_.inside(f), i / stride_);
      std::copy(trace, trace + stride_, kept + i);
    }
  }
  glossy_.store_arriving(m, slots, mirrors);
}

template <std::size_t LinearBands, class Real>
void WallExchange::add_irradiance(OrdinateIndex m, const SweepSlotsOf<Real>& slots,
                                  std::span<const std::int32_t> faces, std::span<double> irradiance) const {
  const std::size_t stride = LinearBands > 0 ? LinearBands : stride_;
  const std::size_t length = LinearBands > 0 ? 3 * LinearBands : face_length_;
  const Vec3 direction = directions_.direction(m);
  for (const std::int32_t f : faces) {
    const auto at = static_cast<std::size_t>(f);
    const double seen = projected_area(faces_[at].area_normal, direction);
    if (seen <= 0) continue;
    const double factor = seen * faces_[at].by_area * directions_.weight(m);
    const FaceCode inside = wall_slots_.inside(f);
    double* sum = irradiance.data() + at * length;
    for (std::size_t i = 0; i < length; i += stride) {
      const Real* trace = slots.face_node(inside, i / stride);
      for (std::size_t b = 0; b < stride; ++b) sum[i + b] += factor * trace[b];
    }
  }
}

void WallExchange::add_leaving(FaceIndex face, std::size_t band, std::span<const double> before,
                               std::span<const double> after, std::span<double> mirrors) const {
  // The half ranges of both sides are equal: with every direction its opposite is in the set.
  const double by_half_range = 1 / half_range_[face.at()];
  if (glossy_.albedo(face, band) > 0) {
    std::vector<double> even;
    for (std::size_t i = face.at() * face_length_ + band; i < (face.at() + 1) * face_length_; i += stride_)
      even.push_back(by_half_range * (after[i] - before[i]));
    glossy_.add_arriving(face, band, even, mirrors);
  }
  const Mirror* by = mirror(face);
  if (by == nullptr || planes_[by->plane].pass == ReflectionPass::this_sweep) return;
  mirrors = mirrors.subspan(glossy_.size());
  for (std::int32_t m = 0; m < directions_.count(); ++m) {
    if (projected_area(mesh_.area_normal(face), directions_.direction(OrdinateIndex(m))) <= 0) continue;
    double* radiance = mirrors.data() + mirror_at(by->row, m);
    for (std::size_t i = band; i < face_length_; i += stride_) {
      const std::size_t at = face.at() * face_length_ + i;
      radiance[i] += by_half_range * (after[at] - before[at]);
    }
  }
}

template void WallExchange::fill(std::span<const double>, const SweepSlotsOf<double>&) const;
template void WallExchange::reflect(OrdinateIndex, const TransportState&, std::span<const double>,
                                    std::span<const double>, const SweepSlotsOf<double>&) const;
template void WallExchange::add_exitance(OrdinateIndex, const SweepSlotsOf<double>&, std::span<double>) const;
template void WallExchange::accumulate_irradiance(OrdinateIndex, const SweepSlotsOf<double>&, AccumulateAt,
                                                  std::span<double>, std::span<double>,
                                                  std::span<double>) const;

template void WallExchange::fill(std::span<const double>, const SweepSlotsOf<float>&) const;
template void WallExchange::reflect(OrdinateIndex, const TransportState&, std::span<const double>,
                                    std::span<const double>, const SweepSlotsOf<float>&) const;
template void WallExchange::add_exitance(OrdinateIndex, const SweepSlotsOf<float>&, std::span<double>) const;
template void WallExchange::accumulate_irradiance(OrdinateIndex, const SweepSlotsOf<float>&, AccumulateAt,
                                                  std::span<double>, std::span<double>,
                                                  std::span<double>) const;

}  // namespace etendue
