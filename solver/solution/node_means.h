// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace etendue {

/// [item][band] the means of [item][node][band]: of linear functions on cells (4 nodes) or faces (3).
std::vector<double> node_means(std::span<const double> values, std::size_t nodes, std::size_t bands);

}  // namespace etendue
