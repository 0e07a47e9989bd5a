// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/random/random_stream.h"

namespace etendue {

/// Random numbers of a history one after the other, for what takes as many as it needs.
class DrawnNumbers {
 public:
  /// The stream must outlive it; it is left after the words that were taken four at a time.
  explicit DrawnNumbers(RandomStream& stream) : stream_(stream) {}

  std::uint32_t word() {
    if (used_ == 4) {
      stream_.next(words_);
      used_ = 0;
    }
    return words_[used_++];
  }
  double number() { return uniform(word()); }  ///< in the open interval (0, 1)

 private:
  RandomStream& stream_;
  std::uint32_t words_[4];
  int used_ = 4;
};

}  // namespace etendue
