// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/media/ray_matter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <utility>

#include "base/parallel/copy_pool.h"
#include "base/quadrature/cell_rule.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/angular/kernels/kernel_places.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/angular/sets/sphere_table.h"
#include "solver/materials/kernels/kernel_formula.h"
#include "solver/materials/kernels/leaf_canopy.h"
#include "solver/materials/kernels/micro_flakes.h"

namespace etendue {
namespace {

/// Rows of the table of the scattering coefficient of a formula by direction: its cubics are off by
/// a millionth of what is as smooth as wz^2.
constexpr int table_rows = 48;
/// It is taken for the same in all directions where it is so to this part in the ordinates of a small set.
constexpr double alike = 1e-9;

/// Ross's G from its values at equal steps of the slope of a ray, cubic between them: rays ask often.
class LeafProjection {
 public:
  explicit LeafProjection(LeafAngles angles) : angles_(angles) {
    if (is_simple()) return;
    for (int i = 0; i <= steps; ++i) {
      const double slope = 0.5 * std::numbers::pi * i / steps;
      values_.push_back(leaf_projection(angles, Vec3(std::cos(slope), 0, std::sin(slope))));
    }
  }
  double at(const Vec3& travel) const {
    if (is_simple()) return leaf_projection(angles_, travel);
    const double place = std::asin(std::min(1.0, std::abs(travel.z()))) / (0.5 * std::numbers::pi) * steps;
    const int first = std::clamp(static_cast<int>(place) - 1, 0, steps - 3);
    const double* v = &values_[static_cast<std::size_t>(first)];
    const double t = place - first;
    return -v[0] * (t - 1) * (t - 2) * (t - 3) / 6 + v[1] * t * (t - 2) * (t - 3) / 2 -
           v[2] * t * (t - 1) * (t - 3) / 2 + v[3] * t * (t - 1) * (t - 2) / 6;
  }

 private:
  /// Returns whether it has a short formula.
  bool is_simple() const {
    return angles_ == LeafAngles::horizontal || angles_ == LeafAngles::vertical ||
           angles_ == LeafAngles::spherical;
  }
  static constexpr int steps = 1024;

  LeafAngles angles_;
  std::vector<double> values_;
};

/// What a formula scatters out of each direction for a density of 1.
class FormulaScattering {
 public:
  explicit FormulaScattering(const KernelFormula& kernel) {
    const auto scattered = [&kernel](const Vec3& travel) {
      return outgoing_moments(kernel, travel).scattered;
    };
    const DirectionSet probes =
        rotated(directions_triangular(4), rotation_about(Vec3(1, 2, 3).normalized(), 40));
    double least = scattered(Vec3::UnitZ()), most = least;
    for (const Vec3& travel : probes.directions()) {
      const double value = scattered(travel);
      least = std::min(least, value);
      most = std::max(most, value);
    }
    constant_ = most;
    if (most - least > alike * most) table_.emplace(table_rows, scattered);
  }
  double at(const Vec3& travel) const { return table_ ? std::max(0.0, table_->at(travel)) : constant_; }

 private:
  double constant_ = 0;
  std::optional<SphereTable> table_;
};

}  // namespace

struct RayMatter::Kind {
  explicit Kind(const DirectionalScattering& what) : scattering(what) {
    if (const auto* leaves = std::get_if<LeafCanopy>(&what)) {
      projection.emplace(leaves->angles);
    } else if (const auto* formula = std::get_if<KernelFormula>(&what)) {
      own_absorption = formula->extinction.has_value();
      reference = formula->extinction ? *formula->extinction : mean_scattering(*formula);
    } else if (const auto* flakes = std::get_if<MicroFlakes>(&what)) {
      reference = mean_flake_projection(*flakes);
    }
  }

  PathCoefficients at(const Vec3& travel) {
    if (const auto* leaves = std::get_if<LeafCanopy>(&scattering)) {
      const double seen = projection->at(travel);
      const double part = leaves->reflectance + leaves->transmittance;
      return {seen * (1 - part), seen * part};
    }
    if (const auto* flakes = std::get_if<MicroFlakes>(&scattering)) {
      const double seen = flake_projection(*flakes, travel);
      return {seen * (1 - flakes->albedo), seen * flakes->albedo};
    }
    const auto& kernel = std::get<KernelFormula>(scattering);
    // Whoever looks first makes the table: without lights nobody does.
    std::call_once(tabulated, [&] { by_formula.emplace(kernel_at(kernel, kernel.place)); });
    const double scattered = by_formula->at(travel);
    if (!kernel.extinction) return {0, scattered};
    return {std::max(0.0, *kernel.extinction - scattered), std::min(scattered, *kernel.extinction)};
  }

  DirectionalScattering scattering;
  /// Value of the medium's coefficients for a density of 1 in the mean over directions; of scattering alone
  /// where its own absorption is not part of it.
  double reference = mean_leaf_projection;
  bool own_absorption = true;
  std::optional<LeafProjection> projection;
  std::once_flag tabulated;
  std::optional<FormulaScattering> by_formula;
};

struct RayMatter::Formula {
  explicit Formula(AngularFormula formula)
      : depends_on_place(formula.depends_on_place()), pool(std::move(formula)) {}
  double at(const Vec3& point, const Vec3& travel) {
    const CopyPool<AngularFormula>::Loan formula(pool);
    return formula->at(point, travel);
  }
  double mean(const std::array<Vec3, 4>& cell, const Vec3& travel) {
    const CopyPool<AngularFormula>::Loan formula(pool);
    double sum = 0;
    for (const CellRulePoint& node : cell_rule())
      sum += node.weight * formula->at(point_at(node.barycentric, cell), travel);
    return sum;
  }

  bool depends_on_place;
  CopyPool<AngularFormula> pool;
};

RayMatter::RayMatter(const Problem& problem)
    : problem_(problem),
      bands_(static_cast<std::size_t>(problem.band_count())),
      linear_(problem),
      empty_(linear_.empty()),
      by_direction_(problem.media().size(), 0),
      entries_(problem.media().size() * bands_) {
  for (std::size_t region = 0; region < problem.media().size(); ++region) {
    const Medium& medium = problem.media()[region];
    for (std::size_t b = 0; b < bands_; ++b) {
      Entry& entry = entries_[region * bands_ + b];
      const auto band = static_cast<int>(b);
      if (medium.is_directional(band) && !std::holds_alternative<KernelMatrix>(medium.directional[b]))
        entry.kind = number_of(medium.directional[b]);
      if (medium.absorbs_by_direction(band)) {
        entry.formula = static_cast<int>(formulas_.size());
        entry.is_extinction = medium.extinction_by_direction;
        formulas_.push_back(std::make_unique<Formula>(*medium.absorption_by_direction[b]));
      }
      if (entry.kind >= 0 || entry.formula >= 0) by_direction_[region] = 1;
    }
    empty_ = empty_ && by_direction_[region] == 0;
  }
}

RayMatter::~RayMatter() = default;

int RayMatter::number_of(const DirectionalScattering& scattering) {
  const auto same = std::ranges::find_if(
      kinds_, [&](const std::unique_ptr<Kind>& kind) { return kind->scattering == scattering; });
  const auto number = static_cast<int>(same - kinds_.begin());
  if (same == kinds_.end()) kinds_.push_back(std::make_unique<Kind>(scattering));
  return number;
}

const DirectionalScattering& RayMatter::scattering(int kind) const {
  return kinds_[static_cast<std::size_t>(kind)]->scattering;
}

RayMatter::View RayMatter::view(const Vec3& travel) const {
  View view{travel, {}, {}};
  for (const auto& kind : kinds_) view.kinds.push_back(kind->at(travel));
  for (const auto& formula : formulas_)
    view.absorption.push_back(formula->depends_on_place ? 0 : formula->at(Vec3::Zero(), travel));
  return view;
}

PathCoefficients RayMatter::at(CellIndex cell, std::size_t band, const View& view) const {
  const auto b = static_cast<int>(band);
  return turned({problem_.absorption(cell, b), problem_.scattering(cell, b)}, cell, band, view);
}

PathCoefficients RayMatter::at(CellIndex cell, std::size_t band, const View& view, const Vec3& point) const {
  if (!linear_.varies(cell)) return at(cell, band, view);
  const auto b = static_cast<int>(band);
  const PathCoefficients here{
      std::max(0.0, problem_.absorption(cell, b) + linear_.absorption(cell, band, point)),
      std::max(0.0, problem_.scattering(cell, b) + linear_.scattering(cell, band, point))};
  return turned(here, cell, band, view);
}

void RayMatter::add_depth(CellIndex cell, const View& view, const Vec3& point, double length,
                          std::span<double> depth) const {
  const bool turns = depends_on_direction(problem_.mesh().region(cell));
  const bool varies = linear_.varies(cell);
  for (std::size_t b = 0; b < bands_; ++b) {
    PathCoefficients here{problem_.absorption(cell, static_cast<int>(b)),
                          problem_.scattering(cell, static_cast<int>(b))};
    if (varies)
      here = {std::max(0.0, here.absorption + linear_.absorption(cell, b, point)),
              std::max(0.0, here.scattering + linear_.scattering(cell, b, point))};
    if (turns) here = turned(here, cell, b, view);
    depth[b] += here.extinction() * length;
  }
}

PathCoefficients RayMatter::along(CellIndex cell, std::size_t band, const Vec3& travel) const {
  const auto b = static_cast<int>(band);
  const Entry& entry = entries_[static_cast<std::size_t>(problem_.mesh().region(cell)) * bands_ + band];
  PathCoefficients unit;
  if (entry.kind >= 0) unit = kinds_[static_cast<std::size_t>(entry.kind)]->at(travel);
  double value = 0;
  if (entry.formula >= 0) {
    Formula& formula = *formulas_[static_cast<std::size_t>(entry.formula)];
    value = formula.depends_on_place ? formula.mean(corners_of(problem_.mesh(), cell), travel)
                                     : formula.at(Vec3::Zero(), travel);
  }
  return composed({problem_.absorption(cell, b), problem_.scattering(cell, b)}, entry, unit, value);
}

PathCoefficients RayMatter::turned(PathCoefficients here, CellIndex cell, std::size_t band,
                                   const View& view) const {
  const Entry& entry = entries_[static_cast<std::size_t>(problem_.mesh().region(cell)) * bands_ + band];
  PathCoefficients unit;
  if (entry.kind >= 0) unit = view.kinds[static_cast<std::size_t>(entry.kind)];
  double value = 0;
  if (entry.formula >= 0) {
    const auto number = static_cast<std::size_t>(entry.formula);
    value = formulas_[number]->depends_on_place
                ? formulas_[number]->mean(corners_of(problem_.mesh(), cell), view.travel)
                : view.absorption[number];
  }
  return composed(here, entry, unit, value);
}

PathCoefficients RayMatter::composed(PathCoefficients here, const Entry& entry, const PathCoefficients& unit,
                                     double value) const {
  if (entry.kind >= 0) {
    const Kind& kind = *kinds_[static_cast<std::size_t>(entry.kind)];
    const double density = (here.scattering + (kind.own_absorption ? here.absorption : 0)) / kind.reference;
    here.scattering = density * unit.scattering;
    if (kind.own_absorption) here.absorption = density * unit.absorption;
  }
  if (entry.formula >= 0)
    here.absorption = entry.is_extinction ? std::max(0.0, value - here.scattering) : value;
  return here;
}

std::string reason_unseen(const Problem& problem, int region) {
  const Medium& medium = problem.medium(region);
  for (int band = 0; band < problem.band_count(); ++band) {
    if (!medium.is_directional(band)) continue;
    const DirectionalScattering& scattering = medium.directional[static_cast<std::size_t>(band)];
    if (std::holds_alternative<KernelMatrix>(scattering))
      return "a kernel that is a matrix, which knows no directions but its ordinates";
    if (!kernel_places(problem, region, band).empty())
      return "a kernel that is another one in each cell, whose integrals along each ray nobody would wait "
             "for";
  }
  return "";
}

}  // namespace etendue
