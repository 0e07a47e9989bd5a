// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace etendue {

/// Copies of a thing that must not be used by two threads at a time, lent to whoever asks.
template <class Thing>
class CopyPool {
 public:
  explicit CopyPool(Thing original) : original_(std::move(original)) {}

  /// A copy of one's own, given back at the end of its life; the pool must outlive it.
  class Loan {
   public:
    explicit Loan(CopyPool& pool) : pool_(pool), thing_(pool.take()) {}
    ~Loan() { pool_.give_back(std::move(thing_)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    const Thing& operator*() const { return *thing_; }
    const Thing* operator->() const { return thing_.get(); }

   private:
    CopyPool& pool_;
    std::unique_ptr<Thing> thing_;
  };

 private:
  std::unique_ptr<Thing> take() {
    const std::lock_guard<std::mutex> lock(lending_);
    if (free_.empty()) return std::make_unique<Thing>(original_);
    std::unique_ptr<Thing> thing = std::move(free_.back());
    free_.pop_back();
    return thing;
  }
  void give_back(std::unique_ptr<Thing> thing) {
    const std::lock_guard<std::mutex> lock(lending_);
    free_.push_back(std::move(thing));
  }

  const Thing original_;
  std::mutex lending_;
  std::vector<std::unique_ptr<Thing>> free_;
};

}  // namespace etendue
