// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/walls/wall_exchange.h"

#include <algorithm>
#include <cmath>

#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/problem/mirror.h"
#include "solver/transport/order/projected_area.h"
#include "solver/transport/order/sweep_order.h"

namespace etendue {
namespace {

/// Values [wall][stride], zero in the padding.
std::vector<double> padded(std::span<const Wall> walls, std::vector<double> Wall::*values,
                           std::size_t stride) {
  std::vector<double> result(walls.size() * stride, 0);
  for (std::size_t w = 0; w < walls.size(); ++w)
    std::copy((walls[w].*values).begin(), (walls[w].*values).end(),
              result.begin() + static_cast<std::ptrdiff_t>(w * stride));
  return result;
}

bool any_positive(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v > 0; });
}

/// [boundary face]
std::vector<double> half_ranges(const TetrahedralMesh& mesh, const DirectionSet& directions) {
  std::vector<double> ranges;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    ranges.push_back(directions.half_range(mesh.area_normal(FaceIndex(f)).normalized()));
  return ranges;
}

}  // namespace

WallExchange::Coefficients::Coefficients(std::span<const Wall> walls, std::size_t stride)
    : radiance(padded(walls, &Wall::radiance, stride)),
      diffuse(padded(walls, &Wall::diffuse, stride)),
      specular(padded(walls, &Wall::specular, stride)),
      transmitted(padded(walls, &Wall::transmittance, stride)) {
  for (const Wall& wall : walls)
    reflects.push_back(any_positive(wall.diffuse) || is_mirror(wall) || wall.is_glossy() ||
                       wall.transmits() || wall.emission_follows);
  for (std::size_t w = 0; w < walls.size(); ++w)
    for (std::size_t b = 0; b < stride; ++b)
      radiance[w * stride + b] *= std::pow(walls[w].refractive_index, 2);
}

WallExchange::WallExchange(const Problem& problem, const DirectionSet& directions,
                           const OrdinateSchedule& schedule, const WallSlots& wall_slots, int stride,
                           int face_nodes)
    : problem_(problem),
      directions_(directions),
      wall_slots_(wall_slots),
      stride_(static_cast<std::size_t>(stride)),
      face_length_(static_cast<std::size_t>(face_nodes) * stride_),
      half_range_(half_ranges(problem.mesh(), directions)),
      walls_(problem.walls(), stride_),
      behind_(any_positive(walls_.transmitted) ? faces_behind(problem.mesh()) : std::vector<std::int32_t>()),
      glossy_(problem, directions, wall_slots, stride, face_nodes),
      mirrors_(problem, directions, schedule, half_range_, face_length_) {
  const TetrahedralMesh& mesh = problem.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const double range = half_range_[face.at()];
    faces_.geometry.push_back({mesh.area_normal(face), 1 / mesh.area(face),
                               range > out_of_reach ? 1 / range : 0,
                               static_cast<std::size_t>(mesh.wall(face))});
    for (std::size_t band = 0; band < stride_; ++band)
      feeds_back_ = feeds_back_ || (range > out_of_reach && fed_back(face, band) > 0) ||
                    walls_.transmitted[faces_.geometry.back().wall * stride_ + band] > 0;
  }
  list_faces();
}

void WallExchange::list_faces() {
  for (std::int32_t f = 0; f < problem_.mesh().boundary_face_count(); ++f) {
    faces_.all.push_back(f);
    if (reflects(FaceIndex(f))) faces_.reflecting.push_back(f);
  }
  for (std::vector<std::int32_t>* list : {&faces_.all, &faces_.reflecting})
    std::stable_sort(list->begin(), list->end(), [this](std::int32_t a, std::int32_t b) {
      const Face &left = faces_.geometry[static_cast<std::size_t>(a)],
                 &right = faces_.geometry[static_cast<std::size_t>(b)];
      return std::pair(octant(left.area_normal), left.wall) <
             std::pair(octant(right.area_normal), right.wall);
    });
}

std::vector<double> WallExchange::emission_range() const {
  std::vector<double> range = half_range_;
  mirrors_.set_emission_range(range);
  return range;
}

std::size_t WallExchange::irradiance_size() const { return half_range_.size() * face_length_; }

double WallExchange::fed_back(FaceIndex face, std::size_t band) const {
  const int wall = problem_.mesh().wall(face);
  return std::min(
      1.0, walls_.diffuse[static_cast<std::size_t>(wall) * stride_ + band] +
               (mirrors_.reflects_later(face) ? mirrored_part_of_isotropic(problem_.wall(wall), band) : 0) +
               glossy_.albedo(face, band));
}

void WallExchange::form_inflow(const TransportState& last, Emission emission, int threads,
                               std::span<double> inflow) {
  glossy_.form(last.mirrors().first(glossy_.size()), threads);
  for (std::size_t f = 0; f < faces_.geometry.size(); ++f) {
    const std::size_t wall = faces_.geometry[f].wall * stride_;
    const double* irradiance = last.irradiance().data() + f * face_length_;
    double* own = inflow.data() + f * face_length_;
    for (std::size_t i = 0; i < face_length_; ++i) {
      const double sent = emission == Emission::included ? walls_.radiance[wall + i % stride_] : 0;
      own[i] = sent + walls_.diffuse[wall + i % stride_] * faces_.geometry[f].by_half_range * irradiance[i];
    }
  }
  if (emission == Emission::included && !problem_.following().radiance.empty()) add_following(inflow);
  // Both sides of a sheet have the same half range and the same nodes.
  for (std::size_t f = 0; f < behind_.size(); ++f) {
    if (behind_[f] < 0) continue;
    const double* irradiance = last.irradiance().data() + static_cast<std::size_t>(behind_[f]) * face_length_;
    for (std::size_t i = 0; i < face_length_; ++i)
      inflow[f * face_length_ + i] += walls_.transmitted[faces_.geometry[f].wall * stride_ + i % stride_] *
                                      faces_.geometry[f].by_half_range * irradiance[i];
  }
}

void WallExchange::add_following(std::span<double> inflow) const {
  const std::size_t nodes = face_length_ / stride_;
  for (std::size_t f = 0; f < faces_.geometry.size(); ++f) {
    if (!problem_.walls()[faces_.geometry[f].wall].emission_follows) continue;
    for (std::size_t i = 0; i < nodes; ++i)
      for (int band = 0; band < problem_.band_count(); ++band) {
        const FaceIndex face(static_cast<std::int32_t>(f));
        inflow[f * face_length_ + i * stride_ + static_cast<std::size_t>(band)] +=
            nodes == 3 ? problem_.following_radiance(face, i, band) : problem_.following_radiance(face, band);
      }
  }
}

template <class Real>
void WallExchange::fill(std::span<const double> inflow, const SweepSlotsOf<Real>& slots) const {
  for (std::size_t f = 0; f < faces_.geometry.size(); ++f) {
    const double* own = inflow.data() + f * face_length_;
    std::copy(own, own + face_length_, slots.slot(wall_slots_.inflow(static_cast<std::int32_t>(f))));
  }
}

template <class Real>
void WallExchange::reflect(OrdinateIndex m, const TransportState& last, std::span<const double> passing,
                           std::span<const double> inflow, const SweepSlotsOf<Real>& slots) const {
  for (const std::int32_t f : mirrors_.faces()) {
    const Face& face = faces_.geometry[static_cast<std::size_t>(f)];
    if (projected_area(face.area_normal, directions_.direction(m)) >= 0) continue;
    const WallMirrors::Mirror& by = *mirrors_.find(FaceIndex(f));
    const WallMirrors::Plane& plane = mirrors_.plane(by);
    // The radiance at glossy walls is stored before that at the mirrors of the next sweep.
    const std::span<const double> from =
        plane.pass == WallMirrors::Pass::this_sweep ? passing : last.mirrors().subspan(glossy_.size());
    const double* mirrored = from.data() + mirrors_.first_number(by, plane.partner[m.at()]);
    const double* own = inflow.data() + static_cast<std::size_t>(f) * face_length_;
    Real* trace = slots.slot(wall_slots_.inflow(f));
    if (!plane.reflected.empty()) {
      const double part = plane.reflected[m.at()];
      for (std::size_t i = 0; i < face_length_; ++i) trace[i] = (1 - part) * own[i] + part * mirrored[i];
      continue;
    }
    for (std::size_t i = 0; i < face_length_; ++i)
      trace[i] = own[i] + walls_.specular[face.wall * stride_ + i % stride_] * mirrored[i];
  }
  glossy_.add_reflected(m, inflow, slots);
}

template <class Real>
void WallExchange::add_exitance(OrdinateIndex m, const SweepSlotsOf<Real>& slots,
                                std::span<double> exitance) const {
  for (std::size_t f = 0; f < faces_.geometry.size(); ++f) {
    const double seen = projected_area(faces_.geometry[f].area_normal, directions_.direction(m));
    if (seen >= 0) continue;
    const double factor = -seen * faces_.geometry[f].by_area * directions_.weight(m);
    const Real* trace = slots.slot(wall_slots_.inflow(static_cast<std::int32_t>(f)));
    for (std::size_t i = 0; i < face_length_; ++i) exitance[f * face_length_ + i] += factor * trace[i];
  }
}

template <class Real>
void WallExchange::accumulate_irradiance(OrdinateIndex m, const SweepSlotsOf<Real>& slots, AccumulateAt what,
                                         std::span<double> irradiance, std::span<double> mirrors,
                                         std::span<double> passing) const {
  const std::span<const std::int32_t> faces = what == AccumulateAt::all ? faces_.all : faces_.reflecting;
  if (stride_ == 1 && face_length_ == 3) {
    add_irradiance<1, Real>(m, slots, faces, irradiance);
  } else {
    add_irradiance<0, Real>(m, slots, faces, irradiance);
  }
  for (const std::int32_t f : mirrors_.faces()) {
    if (projected_area(faces_.geometry[static_cast<std::size_t>(f)].area_normal, directions_.direction(m)) <=
        0)
      continue;
    const WallMirrors::Mirror& by = *mirrors_.find(FaceIndex(f));
    const std::span<double> to =
        mirrors_.plane(by).pass == WallMirrors::Pass::this_sweep ? passing : mirrors.subspan(glossy_.size());
    double* kept = to.data() + mirrors_.first_number(by, m.value());
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
    const double seen = projected_area(faces_.geometry[at].area_normal, direction);
    if (seen <= 0) continue;
    const double factor = seen * faces_.geometry[at].by_area * directions_.weight(m);
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
  if (!mirrors_.reflects_later(face)) return;
  const WallMirrors::Mirror& by = *mirrors_.find(face);
  mirrors = mirrors.subspan(glossy_.size());
  for (std::int32_t m = 0; m < directions_.count(); ++m) {
    if (projected_area(problem_.mesh().area_normal(face), directions_.direction(OrdinateIndex(m))) <= 0)
      continue;
    double* radiance = mirrors.data() + mirrors_.first_number(by, m);
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
