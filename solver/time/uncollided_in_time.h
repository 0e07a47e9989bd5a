// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "solver/time/delayed_field.h"
#include "solver/time/emission_course.h"

namespace etendue {

/// Where light is read: the fluence, or the irradiance on the side of a plane that its unit normal points to.
struct TimedPlace {
  PointInCell at;
  std::optional<Vec3> normal = {};
};

/// Uncollided light of all bands of some DelayFactors.
struct UncollidedValues {
  UncollidedField field;       ///< as DelayedField has it
  std::vector<double> places;  ///< [place][band] [power/length^2]
};

/// The light of a problem's lights before its first collision, in the course of time: by rays, with the time
/// that each takes.
class UncollidedInTime {
 public:
  /// The lights, of which there must be some, must outlive it; `steady` is their uncollided_field(). An
  /// observer that stops it leaves it incomplete.
  UncollidedInTime(const LightSetup& lights, const Slowness& slowness,
                   std::shared_ptr<const UncollidedField> steady, const std::vector<TimedPlace>& places,
                   int threads, const StageObserver& observer = {});

  const LightSetup& lights() const { return times_.lights(); }
  /// The problem without these lights.
  const Problem& remaining() const { return remaining_; }
  /// The course of a source.
  std::size_t course_of(std::size_t source, const EmissionCourses& courses) const;

  UncollidedValues at(const DelayFactors& factors) const;
  /// Changes values that at() has made of as many factors.
  void set(const DelayFactors& factors, UncollidedValues& values) const;
  /// Estimate of the bytes that one will take, with values of so many factors.
  static std::size_t memory(const LightSetup& lights, std::size_t factors);

 private:
  struct Beam {
    std::size_t source;
    double time;
    std::vector<double> light;  ///< [band] of the fluence or irradiance
  };
  UncollidedField shaped(const DelayFactors& factors) const;
  void add_light(std::vector<std::size_t> sources, const StageObserver& observer);
  std::vector<Beam> beams_at(const TimedPlace& place) const;
  void set_places(const DelayFactors& factors, std::vector<double>& places) const;

  int threads_;
  PathTimes times_;
  Problem remaining_;
  std::shared_ptr<const UncollidedField> steady_;
  /// Of one light each, since they may follow courses of their own.
  std::vector<std::unique_ptr<const DelayedField>> fields_;
  std::vector<std::vector<Beam>> places_;
};

/// When what these lights leave emits does, of the courses of all.
EmissionCourses remaining_courses(const LightSetup& lights, const EmissionCourses& courses);

}  // namespace etendue
