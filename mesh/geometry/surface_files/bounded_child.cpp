// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/bounded_child.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <memory>
#include <new>
#include <stdexcept>

#include "base/child_process.h"

namespace etendue {
namespace {

// Exit codes of the child process, beside 0 and those of the system.
constexpr int kRejected = 64;  // the problem is the result
constexpr int kOutOfMemory = 65;

constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;
constexpr std::size_t kLeastMemory = std::size_t{1} << 30;
constexpr double kLeastSeconds = 20;

// Sound input takes less than a tenth of these.
constexpr std::size_t kBytesPerPolygon = 20'000;
constexpr double kSecondsPerPolygon = 1e-3;
constexpr std::size_t kBytesPerFileByte = 200;
constexpr double kSecondsPerFileByte = 2e-6;

std::size_t mapped_memory() {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> status(std::fopen("/proc/self/statm", "r"),
                                                               &std::fclose);
  std::size_t pages = 0;
  if (!status || std::fscanf(status.get(), "%zu", &pages) != 1) return 0;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// Lowers a limit of this process; never raises it.
void lower(int resource, rlim_t most) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, most);
  setrlimit(resource, &limit);
}

void limit_this_process(const ChildLimits& limits) {
  lower(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(std::max(1.0, limits.seconds))));
  lower(RLIMIT_AS, mapped_memory() + limits.bytes);
}

int work_to_file(const std::function<void(std::FILE*)>& work, const ChildLimits& limits,
                 std::FILE* result) try {
  limit_this_process(limits);
  work(result);
  return 0;
} catch (const std::invalid_argument& problem) {
  std::fputs(problem.what(), result);
  return kRejected;
} catch (const std::bad_alloc&) {
  return kOutOfMemory;
}

}  // namespace

ChildLimits limits_for_polygons(std::size_t polygons) {
  return {kLeastSeconds + kSecondsPerPolygon * static_cast<double>(polygons),
          kLeastMemory + kBytesPerPolygon * polygons};
}

ChildLimits limits_for_file(std::size_t bytes) {
  return {kLeastSeconds + kSecondsPerFileByte * static_cast<double>(bytes),
          kLeastMemory + kBytesPerFileByte * bytes};
}

std::string bytes_of_child(const std::string& library, const ChildLimits& limits,
                           const std::function<void(std::FILE*)>& work) {
  ChildOutcome child =
      run_in_child([&](std::FILE* result) { return work_to_file(work, limits, result); }, {});
  if (child.signal == SIGXCPU)
    throw std::invalid_argument(fmt::format(
        "{} does not finish within {:.0f} s of computing; is the file damaged?", library, limits.seconds));
  if (child.signal == 0 && child.exit_code == kRejected) throw std::invalid_argument(child.result);
  if (child.signal == 0 && child.exit_code == kOutOfMemory)
    throw std::invalid_argument(
        fmt::format("{} asks for more than {:.3g} GiB of memory; is the file damaged?", library,
                    static_cast<double>(limits.bytes) / kGibibyte));
  if (child.signal != 0 || child.exit_code != 0)
    throw std::invalid_argument(fmt::format("{} breaks down on it; is the file damaged?", library));
  return std::move(child.result);
}

}  // namespace etendue
