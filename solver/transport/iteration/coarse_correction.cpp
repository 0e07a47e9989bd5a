// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/coarse_correction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace etendue {
namespace {

/// Digits, to the base of e, that the active band with the fewest of them gained.
double fewest_digits(const BandScalars& before, const BandScalars& after, const std::vector<char>& active) {
  double fewest = std::numeric_limits<double>::infinity();
  for (std::size_t band = 0; band < after.size(); ++band)
    if (active[band] && before[band] > 0) fewest = std::min(fewest, std::log(before[band] / after[band]));
  return fewest;
}

}  // namespace

CoarseCorrection::CoarseCorrection(CoarseDirections& coarse, DiffusionAcceleration* acceleration,
                                   const BandVectors& vectors, double cost)
    : coarse_(coarse), acceleration_(acceleration), vectors_(vectors), cost_(cost), spaces_(vectors) {}

TransportState CoarseCorrection::solve(const TransportState& v, double part,
                                       const std::vector<char>& active) {
  const BandScalars start = vectors_.norm(v);
  spaces_.begin(v, start, active);
  parts_.assign(start.size(), 1);
  smallest_.resize(start.size(), 1);
  for (sweeps_ = 0; sweeps_ < longest_basis && std::ranges::max(parts_) > part;) {
    if (!extend(active)) break;
    ++sweeps_;
    for (std::size_t band = 0; band < start.size(); ++band)
      parts_[band] = active[band] && start[band] > 0 ? spaces_.problem(band).residual() / start[band] : 0;
  }
  TransportState z = sweeps_ > 0 ? TransportState(v.layout()) : v;
  for (std::size_t band = 0; sweeps_ > 0 && band < start.size(); ++band)
    smallest_[band] = std::min(smallest_[band], spaces_.problem(band).smallest_singular_value());
  for (std::size_t i = 0; i < sweeps_; ++i) vectors_.add(z, spaces_.coefficients(i), spaces_.vector(i));
  spaces_.clear();
  return z;
}

bool CoarseCorrection::extend(const std::vector<char>& active) {
  TransportState image(spaces_.last().layout());
  coarse_.apply_linear(spaces_.last(), image, active);
  // image = P (I - T) v
  vectors_.scale(image, BandScalars(active.size(), -1));
  vectors_.add(image, BandScalars(active.size(), 1), spaces_.last());
  if (acceleration_ != nullptr) {
    TransportState corrected(image.layout());
    acceleration_->apply(image, corrected, active);
    std::swap(image, corrected);
  }
  const KrylovSpaces::Columns columns = spaces_.orthogonalise(image, active);
  for (const std::vector<double>& column : columns)
    if (!std::ranges::all_of(column, [](double entry) { return std::isfinite(entry); })) return false;
  spaces_.add_columns(columns, active);
  return true;
}

void CoarseCorrection::judge(const BandScalars& before, const BandScalars& after,
                             const std::vector<char>& active) {
  if (sweeps_ == 0) {
    given_up_ = true;
    return;
  }
  const auto sweeps = static_cast<double>(sweeps_);
  const double plain = fewest_digits(BandScalars(parts_.size(), 1), parts_, active) / sweeps;
  const bool pays = fewest_digits(before, after, active) >= plain * (1 + sweeps * cost_);
  vain_ = pays ? 0 : vain_ + 1;
  given_up_ = vain_ >= 2;
}

}  // namespace etendue
