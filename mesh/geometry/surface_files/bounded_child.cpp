// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/bounded_child.h"

#include <fmt/format.h>

#include <csignal>
#include <new>
#include <stdexcept>

#include "base/child_process.h"
#include "base/gibibyte.h"

namespace etendue {
namespace {

// Exit codes of the child process, beside 0 and those of the system.
constexpr int kRejected = 64;  // the problem is the result
constexpr int kOutOfMemory = 65;

constexpr std::size_t kLeastMemory = std::size_t{1} << 30;
constexpr double kLeastSeconds = 20;

// Far above what sound input takes.
constexpr std::size_t kBytesPerPolygon = 20'000;
constexpr double kSecondsPerPolygon = 1e-3;
constexpr std::size_t kBytesPerFileByte = 200;
constexpr double kSecondsPerFileByte = 2e-6;

int work_to_file(const std::function<void(std::FILE*)>& work, const ChildLimits& limits,
                 std::FILE* result) try {
  limit_processor_seconds(limits.seconds);
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
      run_in_child([&](std::FILE* result) { return work_to_file(work, limits, result); }, {}, limits.bytes);
  if (child.signal == SIGXCPU)
    throw std::invalid_argument(fmt::format(
        "{} does not finish within {:.0f} s of computing; is the file damaged?", library, limits.seconds));
  if (child.signal == 0 && child.exit_code == kRejected) throw std::invalid_argument(child.result);
  if (child.signal == 0 && child.exit_code == kOutOfMemory)
    throw std::invalid_argument(
        fmt::format("{} asks for more than {:.3g} GiB of memory; is the file damaged?", library,
                    static_cast<double>(limits.bytes) / gibibyte));
  if (child.signal != 0 || child.exit_code != 0)
    throw std::invalid_argument(fmt::format("{} breaks down on it; is the file damaged?", library));
  return std::move(child.result);
}

}  // namespace etendue
