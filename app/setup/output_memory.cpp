// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/setup/output_memory.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <vector>

#include "app/setup/memory.h"
#include "app/write/result/run_result.h"
#include "base/errors.h"
#include "base/gibibyte.h"

namespace etendue {
namespace {

/// Of a value in a table of text, about [bytes].
constexpr double text_of_value = 100;
/// Of the memory that there is: what takes less is not to blame.
constexpr double least_share = 0.1;

double available_memory() {
  rlimit limit{};
  const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? std::min(installed_memory(), static_cast<double>(limit.rlim_cur)) : installed_memory();
}

/// The radiance, its colors and channels of an image file in single precision [bytes].
double memory_of(const CameraCase& camera, std::size_t bands) {
  const double values = static_cast<double>(bands) * (camera.camera.errors ? 3 : 1);
  const double pixel = values * (sizeof(double) + sizeof(float)) + 3 * (sizeof(double) + sizeof(float));
  return pixel * camera.camera.pixels[0] * camera.camera.pixels[1];
}

/// Points, their rows and their lines in the table [bytes].
double memory_of(const Probe& probe, std::size_t bands) {
  const double values = static_cast<double>(bands) * (sizeof(ProbeValue) + text_of_value);
  return (sizeof(Vec3) + sizeof(ProbeRow) + values) * static_cast<double>(probe.points.size());
}

/// What a camera or a probe takes, and what is wrong where that is too much.
struct Taken {
  double bytes;
  Origin origin;
  std::string problem;
};

std::vector<Taken> all_taken(const Case& input) {
  std::vector<Taken> all;
  const std::size_t bands = input.bands.names.size();
  for (const CameraCase& camera : input.cameras) {
    const double bytes = memory_of(camera, bands);
    all.push_back(
        {bytes, camera.origin,
         fmt::format("a picture of {} x {} pixels and {} bands needs about {:.3g} GiB; use fewer pixels",
                     camera.camera.pixels[0], camera.camera.pixels[1], bands, bytes / gibibyte)});
  }
  for (const Probe& probe : input.probes) {
    const double bytes = memory_of(probe, bands);
    all.push_back({bytes, probe.origin,
                   fmt::format("{} points and {} bands need about {:.3g} GiB; use fewer points",
                               probe.points.size(), bands, bytes / gibibyte)});
  }
  return all;
}

double sum_of(const std::vector<Taken>& all) {
  double sum = 0;
  for (const Taken& taken : all) sum += taken.bytes;
  return sum;
}

}  // namespace

double output_memory(const Case& input) { return sum_of(all_taken(input)); }

void check_output_memory(const Case& input) {
  const std::vector<Taken> all = all_taken(input);
  const double needed = sum_of(all);
  const double available = available_memory();
  if (needed <= available) return;
  std::vector<Fault> faults;
  for (const Taken& taken : all)
    if (taken.bytes > least_share * available || taken.bytes * static_cast<double>(all.size()) >= needed)
      faults.push_back(fault_at(
          taken.origin, "", fmt::format("{} ({:.3g} GiB are there)", taken.problem, available / gibibyte)));
  throw InputError(std::move(faults));
}

}  // namespace etendue
