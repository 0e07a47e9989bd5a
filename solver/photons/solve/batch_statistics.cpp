// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/solve/batch_statistics.h"

#include <cmath>
#include <limits>

namespace etendue {

void BatchStatistics::add(std::span<const double> values, double histories) {
  first_.resize(values.size());
  second_.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    first_[i] += histories * values[i];
    second_[i] += histories * values[i] * values[i];
  }
  histories_ += histories;
  ++batches_;
}

double BatchStatistics::error(std::size_t i) const {
  if (batches_ < 2) return std::numeric_limits<double>::infinity();
  const double spread = second_[i] - first_[i] * first_[i] / histories_;
  return spread > 0 ? std::sqrt(spread / ((batches_ - 1) * histories_)) : 0;
}

std::vector<double> BatchStatistics::means() const {
  std::vector<double> values(size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = mean(i);
  return values;
}

std::vector<double> BatchStatistics::errors() const {
  std::vector<double> values(size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = error(i);
  return values;
}

std::vector<double> BatchStatistics::packed() const {
  if (batches_ == 0) return {};
  std::vector<double> numbers = {static_cast<double>(batches_), histories_};
  numbers.insert(numbers.end(), first_.begin(), first_.end());
  numbers.insert(numbers.end(), second_.begin(), second_.end());
  return numbers;
}

BatchStatistics BatchStatistics::unpacked(std::span<const double> numbers) {
  BatchStatistics statistics;
  if (numbers.size() < 2 || !(numbers[0] >= 1 && numbers[0] <= std::numeric_limits<int>::max()))
    return statistics;
  statistics.batches_ = static_cast<int>(numbers[0]);
  statistics.histories_ = numbers[1];
  const std::size_t count = (numbers.size() - 2) / 2;
  statistics.first_.assign(numbers.begin() + 2, numbers.begin() + 2 + static_cast<std::ptrdiff_t>(count));
  statistics.second_.assign(numbers.begin() + 2 + static_cast<std::ptrdiff_t>(count), numbers.end());
  return statistics;
}

}  // namespace etendue
