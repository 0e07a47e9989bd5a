// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/walls/wall_matrix.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace etendue {
namespace {

/// Relative error of the energy of a row, and the steps of the scaling that it must be reached in.
constexpr double exact = 1e-13;
constexpr int most_steps = 100000;
/// A row whose sum is this part of the albedo sees nothing of the lobe.
constexpr double unseen = 1e-6;

}  // namespace

WallMatrix::WallMatrix(const DirectionSet& directions, const Vec3& normal, const Reflectance& reflectance) {
  const Eigen::Index pairs = directions.count() / 2;
  Eigen::VectorXd across(pairs), albedo(pairs);
  std::vector<Vec3> arriving;
  for (Eigen::Index p = 0; p < pairs; ++p) {
    const OrdinateIndex first(2 * p);
    const double cosine = directions.direction(first).dot(normal);
    arriving.push_back(cosine < 0 ? Vec3(-directions.direction(first)) : directions.direction(first));
    across[p] = directions.weight(first) * std::abs(cosine);
    albedo[p] = cosine != 0 ? reflectance.albedo(std::abs(cosine)) : 0;
  }
  entries_.resize(pairs, pairs);
  for (Eigen::Index p = 0; p < pairs; ++p)
    for (Eigen::Index q = 0; q <= p; ++q)
      entries_(p, q) = entries_(q, p) = reflectance.between(arriving[static_cast<std::size_t>(q)],
                                                            -arriving[static_cast<std::size_t>(p)], -normal);
  for (Eigen::Index p = 0; p < pairs; ++p) {
    if (albedo[p] <= 0 || entries_.row(p).dot(across) > unseen * albedo[p]) continue;
    Eigen::Index nearest = p;
    double best = -2;
    for (Eigen::Index q = 0; q < pairs; ++q) {
      const Vec3 &in = arriving[static_cast<std::size_t>(p)], &out = arriving[static_cast<std::size_t>(q)];
      const double cosine = cosine_off_mirror(in.dot(normal), out.dot(normal), in.dot(out));
      if (across[q] > 0 && cosine > best) {
        best = cosine;
        nearest = q;
      }
    }
    entries_(p, nearest) = entries_(nearest, p) = albedo[p] / across[nearest];
  }
  scale(across, albedo);
  mean_albedo_ = across.dot(albedo) / across.sum();
}

// Rows and columns by the same factors: s <- sqrt(s a / (F c s)) has the wanted s as its fixed point, and the
// geometric mean keeps rows that lean on each other from swinging.
void WallMatrix::scale(const Eigen::VectorXd& across, const Eigen::VectorXd& albedo) {
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(across.size());
  for (int step = 0;; ++step) {
    const Eigen::VectorXd sums = factors.cwiseProduct(entries_ * across.cwiseProduct(factors));
    double smallest = HUGE_VAL, largest = 0;
    for (Eigen::Index p = 0; p < sums.size(); ++p) {
      if (albedo[p] <= 0) continue;
      const double ratio = sums[p] / albedo[p];
      smallest = std::min(smallest, ratio);
      largest = std::max(largest, ratio);
      factors[p] /= std::sqrt(ratio);
    }
    if (step == 0 && largest > 0) row_sums_ = {smallest, largest};
    if (largest == 0 || (smallest > 1 - exact && largest < 1 + exact)) break;
    if (step == most_steps) throw std::logic_error("the scaling of a wall's matrix does not end");
  }
  entries_ = factors.asDiagonal() * entries_ * across.cwiseProduct(factors).asDiagonal();
}

}  // namespace etendue
