// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange/factor_checks.h"

#include <algorithm>
#include <cmath>

#include "base/random/random_stream.h"
#include "solver/radiosity/form_factors/exchange_area.h"

namespace etendue {
namespace {

constexpr std::uint64_t sampled_pairs = 200;

/// Two halves of a patch of several triangles, four quarters of one.
std::vector<FlatPatch> parts_of(const FlatPatch& patch) {
  const std::vector<TriangleCorners>& all = patch.triangles();
  if (all.size() > 1) {
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    return {FlatPatch({all.begin(), middle}), FlatPatch({middle, all.end()})};
  }
  const TriangleCorners& t = all[0];
  const Vec3 ab = (t[0] + t[1]) / 2, bc = (t[1] + t[2]) / 2, ca = (t[2] + t[0]) / 2;
  return {FlatPatch({{t[0], ab, ca}}), FlatPatch({{ab, t[1], bc}}), FlatPatch({{ca, bc, t[2]}}),
          FlatPatch({{ab, bc, ca}})};
}

/// Both ways, and the second patch in parts.
void check_pair(const FlatPatch& j, const FlatPatch& k, FactorChecks& checks) {
  const double forth = exchange_area(j, k), back = exchange_area(k, j);
  checks.reciprocity = std::max(checks.reciprocity, std::abs(forth - back) / std::min(j.area(), k.area()));
  double sum = 0;
  for (const FlatPatch& part : parts_of(k)) sum += exchange_area(j, part);
  checks.additivity = std::max(checks.additivity, std::abs(forth - sum) / j.area());
}

}  // namespace

FactorChecks check_and_close(Exchange& exchange, double tolerance) {
  const std::vector<FlatPatch>& patches = exchange.patches();
  FactorChecks checks;
  for (const FlatPatch& patch : patches)
    checks.self = std::max(checks.self, exchange_area(patch, patch) / patch.area());
  for (std::uint64_t i = 0; i < sampled_pairs; ++i) {
    RandomStream stream(0, i, RandomUse::form_factor);
    std::uint32_t word[4];
    stream.next(word);
    const auto j = word[0] % patches.size(), k = word[1] % patches.size();
    if (j != k) check_pair(patches[j], patches[k], checks);
  }
  const Exchange::RowSums found = exchange.row_sums();
  checks.row_sum = found.largest;
  checks.row_sum_mean = found.root_mean_square;
  checks.closing_passes = exchange.close(tolerance);
  checks.closed_row_sum = exchange.row_sums().largest;
  return checks;
}

}  // namespace etendue
