// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/quadrature/cell_rule.h"
#include "base/quadrature/collapsed_rule.h"
#include "base/quadrature/simplex_rules.h"
#include "solver/uncollided/moments/nodal_moments.h"

namespace etendue {

namespace detail {

inline const auto& rule_of_degree_five(const SubTetrahedron&) { return cell_rule(); }
inline const auto& rule_of_degree_five(const SubTriangle&) { return seven_point_rule(); }

/// How often a cell in an edge of a body that shines is divided, all corners of which lie on its surface: no
/// rule can be collapsed towards all of them.
constexpr int divisions_within_surface = 2;

template <std::size_t corners, class SteepOf, class AddPoint>
class AdaptiveSum {
 public:
  using Part = std::array<std::array<double, corners>, corners>;

  AdaptiveSum(const SteepOf& steep_of, double tolerance, const AddPoint& add_point, NodalMoments& moments)
      : steep_of_(steep_of), tolerance_(tolerance), add_point_(add_point), moments_(moments) {}

  void add(const Part& part, double measure, int divisions, int divisions_within = divisions_within_surface) {
    if (corners == 4 && divisions_within > 0 && steep_of_(part).surface.all()) {
      const auto parts = equal_parts(part);
      for (const Part& child : parts)
        add(child, measure / static_cast<double>(parts.size()), 0, divisions_within - 1);
      return;
    }
    const NodalMoments coarse = by_rule(part, measure);
    if (divisions == 0) return moments_.add(coarse);
    refine(part, measure, coarse, tolerance_ * coarse.size(), divisions);
  }

 private:
  NodalMoments by_rule(const Part& part, double measure) const {
    NodalMoments sum = moments_;
    sum.clear();
    const auto add = [&](const auto& point) {
      add_point_(in_whole(point.barycentric, part), point.weight * measure, sum);
    };
    const auto collapsed = collapsed_rule<corners>(steep_of_(part));
    if (!collapsed.empty())
      for (const auto& point : collapsed) add(point);
    else
      for (const auto& point : rule_of_degree_five(part)) add(point);
    return sum;
  }

  void refine(const Part& part, double measure, const NodalMoments& coarse, double allowed, int divisions) {
    const auto parts = equal_parts(part);
    const double part_measure = measure / static_cast<double>(parts.size());
    std::vector<NodalMoments> fine;
    NodalMoments sum = coarse;
    sum.clear();
    for (const Part& child : parts) {
      fine.push_back(by_rule(child, part_measure));
      sum.add(fine.back());
    }
    if (divisions == 1 || sum.difference(coarse) <= allowed) return moments_.add(sum);
    for (std::size_t i = 0; i < parts.size(); ++i)
      refine(parts[i], part_measure, fine[i], allowed, divisions - 1);
  }

  const SteepOf& steep_of_;
  double tolerance_;
  const AddPoint& add_point_;
  NodalMoments& moments_;
};

}  // namespace detail

/// Adds `add_point(barycentric, measure, moments)` over a cell or a face by rules of degree 5, of fourteen
/// points or of seven; in parts of which `steep_of` finds corners steep by rules that are collapsed towards
/// these. The whole is divided, in eight or in four, while that changes the integral of the first component
/// by more than `tolerance` of the whole, `divisions` times at most.
template <std::size_t corners, class SteepOf, class AddPoint>
void add_adaptively(const std::array<std::array<double, corners>, corners>& whole, double measure,
                    const SteepOf& steep_of, double tolerance, int divisions, const AddPoint& add_point,
                    NodalMoments& moments) {
  detail::AdaptiveSum<corners, SteepOf, AddPoint>(steep_of, tolerance, add_point, moments)
      .add(whole, measure, divisions);
}

}  // namespace etendue
