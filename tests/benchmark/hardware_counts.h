// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <utility>

namespace etendue {

/// Cycles and instructions of this process and the threads that it starts, from now on. Zeros where the
/// machine does not count or does not tell, as most virtual ones.
class HardwareCounts {
 public:
  HardwareCounts() : files_{open(PERF_COUNT_HW_CPU_CYCLES), open(PERF_COUNT_HW_INSTRUCTIONS)} {}
  ~HardwareCounts() {
    for (const int file : files_)
      if (file >= 0) close(file);
  }
  HardwareCounts(const HardwareCounts&) = delete;
  HardwareCounts& operator=(const HardwareCounts&) = delete;

  std::pair<std::int64_t, std::int64_t> read() const { return {read(files_[0]), read(files_[1])}; }

 private:
  static int open(std::uint64_t event) {
    perf_event_attr attributes{};
    attributes.type = PERF_TYPE_HARDWARE;
    attributes.size = sizeof attributes;
    attributes.config = event;
    attributes.inherit = 1;
    attributes.exclude_kernel = 1;
    attributes.exclude_hv = 1;
    return static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
  }
  static std::int64_t read(int file) {
    std::int64_t count = 0;
    return file >= 0 && ::read(file, &count, sizeof count) == sizeof count ? count : 0;
  }

  std::array<int, 2> files_;
};

}  // namespace etendue
