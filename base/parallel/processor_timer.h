// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ctime>

namespace etendue {

/// Processor time that this thread has taken [s].
inline double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Adds the processor time of this thread to a sum while it lives. Threads that wait for others are not
/// counted.
class ProcessorTimer {
 public:
  explicit ProcessorTimer(double& sum) : sum_(sum), start_(processor_seconds()) {}
  ~ProcessorTimer() {
    const double spent = processor_seconds() - start_;
#pragma omp atomic
    sum_ += spent;
  }
  ProcessorTimer(const ProcessorTimer&) = delete;
  ProcessorTimer& operator=(const ProcessorTimer&) = delete;

 private:
  double& sum_;
  double start_;
};

}  // namespace etendue
