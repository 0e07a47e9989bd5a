// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/heat/temperature_space.h"
#include "solver/problem/problem.h"

namespace etendue {

/// The heat that media and walls hold, at vertices as their other heat is lumped.
class HeatStorage {
 public:
  /// The arguments must outlive it. Of a problem that does not change with time nothing holds heat. Throws
  /// InputError where a heat capacity is negative or not finite at the temperatures of the start.
  HeatStorage(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space);

  /// [unknown] dH/dT at temperatures [J/K]; 0 where none is held.
  std::vector<double> capacity(std::span<const double> temperature) const;
  /// [unknown] Heat from one temperature to another [J]: a Gauss rule of 5 points in the temperature.
  std::vector<double> heat(std::span<const double> from, std::span<const double> to) const;
  /// [unknown] Temperatures at t = 0 [K].
  std::vector<double> start() const;

 private:
  /// What an unknown has of one medium or wall.
  struct Place {
    std::size_t unknown;
    const HeatInTime* in_time;
    const Origin* origin;
    double size;  ///< [m^3], of a wall [m^2]
    Vec3 point;
  };
  double capacity_at(const Place& place, double kelvin) const;

  const HeatProblem& heat_;
  std::size_t size_;
  std::vector<Place> places_;
};

}  // namespace etendue
