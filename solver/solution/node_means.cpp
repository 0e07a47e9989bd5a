// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/node_means.h"

namespace etendue {

std::vector<double> node_means(std::span<const double> values, std::size_t nodes, std::size_t bands) {
  std::vector<double> means(values.size() / nodes);
  for (std::size_t i = 0; i < means.size(); ++i) {
    const double* first = &values[i / bands * nodes * bands + i % bands];
    for (std::size_t node = 0; node < nodes; ++node) means[i] += first[node * bands];
    means[i] /= static_cast<double>(nodes);
  }
  return means;
}

}  // namespace etendue
