// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/reflectance_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "base/degree.h"
#include "base/quadrature/panel_rule.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// How much f_r may differ, as a part of the larger value, when light goes the other way: what two readings
/// of one instrument differ by.
constexpr double both_ways = 0.02;
/// Of the integrals in one interval of the grid, where the reflectance itself is linear.
constexpr int interval_panels = 16;

std::vector<double> distinct(const std::vector<ReflectancePoint>& points, double ReflectancePoint::*which) {
  std::vector<double> values;
  for (const ReflectancePoint& point : points) values.push_back(point.*which);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::vector<ReflectancePoint> in_order(std::vector<ReflectancePoint> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return std::tie(a.angle_in, a.angle_out, a.azimuth) < std::tie(b.angle_in, b.angle_out, b.azimuth);
  });
  return points;
}

std::string shown(const ReflectancePoint& point) {
  return fmt::format("in = {:g}, out = {:g}, azimuth = {:g} degrees", point.angle_in, point.angle_out,
                     point.azimuth);
}

/// Where a value lies among rising ones: the one before, and how far towards the next.
struct Place {
  std::size_t before;
  double part;
};
Place place_of(const std::vector<double>& values, double value) {
  if (values.size() == 1 || value <= values.front()) return {0, 0};
  if (value >= values.back()) return {values.size() - 2, 1};
  const auto next = std::upper_bound(values.begin(), values.end(), value) - values.begin();
  const auto before = static_cast<std::size_t>(next - 1);
  return {before, (value - values[before]) / (values[before + 1] - values[before])};
}

/// 0, the values between and `end`: where what is linear between the values has kinks.
std::vector<double> parts_of(const std::vector<double>& values, double end) {
  std::vector<double> parts{0};
  for (const double value : values)
    if (value > parts.back() && value < end) parts.push_back(value);
  parts.push_back(end);
  return parts;
}

}  // namespace

std::string ReflectanceTable::problem_of(const std::vector<ReflectancePoint>& points) {
  if (points.empty()) return "no points; give angle_in, angle_out, azimuth and value on each line";
  for (const ReflectancePoint& point : points) {
    const bool inside = point.angle_in >= 0 && point.angle_in <= 90 && point.angle_out >= 0 &&
                        point.angle_out <= 90 && point.azimuth >= 0 && point.azimuth <= 180;
    if (!inside)
      return "angles out of range at " + shown(point) + "; use 0 to 90 from the normal and 0 to 180 about it";
    if (!(point.value >= 0 && std::isfinite(point.value)))
      return fmt::format("value {:g} at {}; use finite values of at least 0", point.value, shown(point));
  }
  const std::vector<double> in = distinct(points, &ReflectancePoint::angle_in);
  if (in != distinct(points, &ReflectancePoint::angle_out))
    return "the angles in and out differ; use the same, so that both ways of light can be compared";
  const std::size_t azimuths = distinct(points, &ReflectancePoint::azimuth).size();
  const std::vector<ReflectancePoint> sorted = in_order(points);
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (std::tie(sorted[i].angle_in, sorted[i].angle_out, sorted[i].azimuth) ==
        std::tie(sorted[i - 1].angle_in, sorted[i - 1].angle_out, sorted[i - 1].azimuth))
      return "two values at " + shown(sorted[i]) + "; give one";
  if (sorted.size() != in.size() * in.size() * azimuths)
    return fmt::format("{} points are no whole grid of {} by {} angles and {} azimuths; give all of them",
                       sorted.size(), in.size(), in.size(), azimuths);
  for (std::size_t i = 0; i < in.size(); ++i)
    for (std::size_t o = 0; o < i; ++o)
      for (std::size_t a = 0; a < azimuths; ++a) {
        const ReflectancePoint& there = sorted[(i * in.size() + o) * azimuths + a];
        const ReflectancePoint& back = sorted[(o * in.size() + i) * azimuths + a];
        if (std::abs(there.value - back.value) <= both_ways * std::max(there.value, back.value)) continue;
        return fmt::format("not reciprocal: {:g} at {} and {:g} the other way; they may differ by {:g} %",
                           there.value, shown(there), back.value, 100 * both_ways);
      }
  return "";
}

ReflectanceTable::ReflectanceTable(const std::vector<ReflectancePoint>& points, double factor)
    : angles_(distinct(points, &ReflectancePoint::angle_in)),
      azimuths_(distinct(points, &ReflectancePoint::azimuth)) {
  for (double& angle : angles_) angle *= one_degree;
  for (double& azimuth : azimuths_) azimuth *= one_degree;
  for (const ReflectancePoint& point : in_order(points)) values_.push_back(factor * point.value);
  for (std::size_t i = 0; i < angles_.size(); ++i)
    for (std::size_t o = 0; o < i; ++o)
      for (std::size_t a = 0; a < azimuths_.size(); ++a) {
        double& there = values_[(i * angles_.size() + o) * azimuths_.size() + a];
        double& back = values_[(o * angles_.size() + i) * azimuths_.size() + a];
        there = back = (there + back) / 2;
      }
  set_albedo(AlbedoTable([this](double cos_in) { return exact_albedo(cos_in); }));
}

double ReflectanceTable::at(double angle_in, double angle_out, double azimuth) const {
  const Place in = place_of(angles_, angle_in), out = place_of(angles_, angle_out);
  const Place turn = place_of(azimuths_, azimuth);
  double sum = 0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const bool i = (corner & 1) != 0, o = (corner & 2) != 0, a = (corner & 4) != 0;
    const double share =
        (i ? in.part : 1 - in.part) * (o ? out.part : 1 - out.part) * (a ? turn.part : 1 - turn.part);
    if (share > 0) sum += share * node(in.before + i, out.before + o, turn.before + a);
  }
  return sum;
}

double ReflectanceTable::value(double cos_in, double cos_out, double between) const {
  const double sines = std::sqrt(std::max(0.0, (1 - cos_in * cos_in) * (1 - cos_out * cos_out)));
  // Along the normal there is no azimuth, and the table says the same for all of them but for its errors.
  const double azimuth =
      sines > 0 ? std::acos(std::clamp((between - cos_in * cos_out) / sines, -1.0, 1.0)) : 0;
  return at(std::acos(std::min(1.0, cos_in)), std::acos(std::min(1.0, cos_out)), azimuth);
}

double ReflectanceTable::exact_albedo(double cos_in) const {
  const double angle_in = std::acos(cos_in);
  const std::vector<double> outs = parts_of(angles_, pi / 2), turns = parts_of(azimuths_, pi);
  double sum = 0;
  for (std::size_t o = 1; o < outs.size(); ++o)
    for (std::size_t t = 1; t < turns.size(); ++t)
      sum += integral_by_panels(outs[o - 1], outs[o], interval_panels, [&](double out) {
        return std::sin(2 * out) * integral_by_panels(turns[t - 1], turns[t], 1, [&](double azimuth) {
                 return at(angle_in, out, azimuth);
               });
      });
  return sum;
}

// Lambert's directions, weighed by the table.
ReflectedRay ReflectanceTable::sample(double cos_in, double u, double v) const {
  const double sin_in = std::sqrt(std::max(0.0, 1 - cos_in * cos_in));
  const double radius = std::sqrt(u), cos_out = std::sqrt(1 - u);
  const Vec3 out(radius * std::cos(2 * pi * v), radius * std::sin(2 * pi * v), cos_out);
  return {out, pi * value(cos_in, cos_out, sin_in * out.x() + cos_in * cos_out)};
}

}  // namespace etendue
