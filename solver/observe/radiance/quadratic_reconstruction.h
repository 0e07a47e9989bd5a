// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "solver/problem/problem.h"
#include "solver/solution/saved_state.h"

namespace etendue {

/// Values of a quadratic in a cell: at its four vertices, and how far it is from linear in the middle of each
/// of its edges,
///
///     f = sum over i of f_i l_i + sum over edges (a, b) of 4 l_a l_b c_ab,  l barycentric.
inline constexpr std::size_t quadratic_nodes = 10;
/// The vertices at the ends of the edges, in the order of c_ab.
inline constexpr std::array<std::pair<std::size_t, std::size_t>, 6> cell_edges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// A state of linear elements with quadratics for its fluence and moments, quadratic_nodes values a cell:
/// that of which the best linear fits in the cells around, two faces away at most and of the same region, are
/// nearest to what the elements have there (least squares), while in the cell itself it is that exactly
/// (Dumbser, Balsara, Toro and Munz 2008). A quadratic is found again from its fits, so that of smooth light
/// the difference tells the error of linear elements. Moments stay linear where a cell around has none.
/// `rows` [cell] are those of CollidedSource. What walls receive stays.
SavedState quadratic_reconstruction(const Problem& problem, const SavedState& state,
                                    std::span<const std::int32_t> rows, int threads);

}  // namespace etendue
