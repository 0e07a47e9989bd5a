// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/lights/nodal_moments.h"
#include "solver/lights/simplex_rules.h"
#include "solver/problem/cell_rule.h"

namespace etendue {

namespace detail {

inline const auto& rule_of(const SubTetrahedron&) { return cell_rule(); }
inline const auto& rule_of(const SubTriangle&) { return seven_point_rule(); }

template <class Part, class AddPoint>
NodalMoments by_rule(const Part& part, double measure, const AddPoint& add_point, const NodalMoments& like) {
  NodalMoments sum = like;
  sum.clear();
  for (const auto& point : rule_of(part))
    add_point(in_whole(point.barycentric, part), point.weight * measure, sum);
  return sum;
}

template <class Part, class AddPoint>
void refine(const Part& part, double measure, const NodalMoments& coarse, double allowed, int divisions,
            const AddPoint& add_point, NodalMoments& moments) {
  const auto parts = equal_parts(part);
  const double part_measure = measure / static_cast<double>(parts.size());
  std::vector<NodalMoments> fine;
  NodalMoments sum = coarse;
  sum.clear();
  for (const Part& child : parts) {
    fine.push_back(by_rule(child, part_measure, add_point, coarse));
    sum.add(fine.back());
  }
  if (divisions == 1 || sum.difference(coarse) <= allowed) return moments.add(sum);
  for (std::size_t i = 0; i < parts.size(); ++i)
    refine(parts[i], part_measure, fine[i], allowed, divisions - 1, add_point, moments);
}

}  // namespace detail

/// Adds `add_point(barycentric, measure, moments)` by rules of degree 5 over a part of a cell or a face: of
/// fourteen points, or of seven. The part is divided further, in eight or in four, while that changes the
/// integral of the first component by more than `tolerance` of the whole, `divisions` times at most.
template <class Part, class AddPoint>
void add_adaptively(const Part& part, double measure, double tolerance, int divisions,
                    const AddPoint& add_point, NodalMoments& moments) {
  const NodalMoments coarse = detail::by_rule(part, measure, add_point, moments);
  if (divisions == 0) return moments.add(coarse);
  detail::refine(part, measure, coarse, tolerance * coarse.size(), divisions, add_point, moments);
}

}  // namespace etendue
