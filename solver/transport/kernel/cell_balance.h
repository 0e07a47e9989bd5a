// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/transport/kernel/kernel_inline.h"

namespace etendue {

// Upwind discontinuous Galerkin on one straight tetrahedron, linear basis: (5) of docs/theory/theory.md. All
// equations are multiplied by 12. Face f lies opposite vertex f; a_f = w . (A_f n_f) is its area seen along
// the direction, positive where light leaves. The four a_f sum to zero.
//
// With p_f = max(a_f, 0), n_f = max(-a_f, 0), P = sum of p_f = sum of n_f, the matrix of the four nodal
// values is
//
//     alpha I + beta 1 1^T - n 1^T - 1 p^T,    alpha = P + alpha_mass,  beta = P + beta_mass,
//
// the identity plus rank two. The mass is consistent, (6), with alpha_mass = beta_mass = 0.6 sigma_t V, and
// lumped, (8), with alpha_mass = 3 sigma_t V, beta_mass = 0. Both keep the column sums, so both keep the
// cell's balance.

//
// T is a number, or a packet of them (packet.h). The areas are real numbers A; what else there is may be
// complex (complex_lanes.h).

/// Projected areas of the four faces of a cell along one direction [length^2].
template <class T>
struct ProjectedAreas {
  T outgoing[4];  ///< p_f
  T incoming[4];  ///< n_f
  T total;        ///< P
};

template <class T>
ETENDUE_KERNEL_INLINE ProjectedAreas<T> projected_areas(const T (&a)[4]) {
  ProjectedAreas<T> areas;
  ETENDUE_UNROLL
  for (int f = 0; f < 4; ++f) {
    areas.outgoing[f] = a[f] > 0 ? a[f] : T{};
    areas.incoming[f] = areas.outgoing[f] - a[f];
  }
  areas.total = (areas.outgoing[0] + areas.outgoing[1]) + (areas.outgoing[2] + areas.outgoing[3]);
  return areas;
}

/// Adds the inflow through face f, with the nodal values u[0 … 2] at its vertices, to the right-hand side:
/// 12 times n_f times the face's mass matrix, n_f (sum of u + u_i).
template <class A, class T>
ETENDUE_KERNEL_INLINE void add_inflow(const ProjectedAreas<A>& areas, int f, const T* u, T (&right)[4]) {
  const T sum = areas.incoming[f] * (u[0] + u[1] + u[2]);
  int corner = 0;
  ETENDUE_UNROLL
  for (int i = 0; i < 4; ++i) {
    if (i == f) continue;
    right[i] += sum + areas.incoming[f] * u[corner++];
  }
}

template <class T>
ETENDUE_KERNEL_INLINE T reciprocal(const T& a) {
  return 1.0 / a;
}

/// Part of the inverse matrix that needs no light: it has the only division, which takes long. So it is
/// begun before the light that enters is read.
template <class T>
struct CellInverse {
  T alpha_mass;
  T beta;
  T first;  ///< alpha + 4 beta - P
  T beta_total;
  T by_alpha;
  T by_determinant;
};

template <class A, class T>
ETENDUE_KERNEL_INLINE CellInverse<T> invert_cell(const ProjectedAreas<A>& areas, const T& alpha_mass,
                                                 const T& beta_mass) {
  CellInverse<T> cell;
  cell.alpha_mass = alpha_mass;
  cell.beta = beta_mass + areas.total;
  cell.first = alpha_mass + 4.0 * cell.beta;
  cell.beta_total = areas.total * cell.beta;
  const T alpha = alpha_mass + areas.total;
  const T determinant = cell.first * alpha_mass + 4.0 * cell.beta_total;
  // One division serves both the determinant and alpha.
  const T inverse = reciprocal(determinant * alpha);
  cell.by_determinant = inverse * alpha;
  cell.by_alpha = inverse * determinant;
  return cell;
}

/// The nodal values from 12 times the right-hand side, in closed form, (7) or (9): with S the sum of the
/// values and T = p . u, two equations in two unknowns whose determinant is positive, in vacuum too.
template <class A, class T>
ETENDUE_KERNEL_INLINE void solve_cell(const ProjectedAreas<A>& areas, const CellInverse<T>& cell,
                                      const T (&right)[4], T (&u)[4]) {
  const T sum_right = (right[0] + right[1]) + (right[2] + right[3]);
  const T weighted_right = (areas.outgoing[0] * right[0] + areas.outgoing[1] * right[1]) +
                           (areas.outgoing[2] * right[2] + areas.outgoing[3] * right[3]);
  const T sum = (cell.alpha_mass * sum_right + 4.0 * weighted_right) * cell.by_determinant;
  const T weighted = (cell.first * weighted_right - cell.beta_total * sum_right) * cell.by_determinant;
  const T common = weighted - cell.beta * sum;
  ETENDUE_UNROLL
  for (int i = 0; i < 4; ++i) u[i] = (right[i] + common + areas.incoming[i] * sum) * cell.by_alpha;
}

}  // namespace etendue
