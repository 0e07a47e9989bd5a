// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ctime>

namespace etendue {

/// Adds the processor time of this thread to a sum while it lives. Threads that wait for others are not
/// counted.
class ProcessorTimer {
 public:
  explicit ProcessorTimer(double& sum) : sum_(sum), start_(now()) {}
  ~ProcessorTimer() {
    const double spent = now() - start_;
#pragma omp atomic
    sum_ += spent;
  }
  ProcessorTimer(const ProcessorTimer&) = delete;
  ProcessorTimer& operator=(const ProcessorTimer&) = delete;

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double& sum_;
  double start_;
};

}  // namespace etendue
