// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace etendue {

/// Values at given cosines, linear in between, divided by the integral over the sphere.
class PhaseTable {
 public:
  /// Cosines from -1 to 1, rising or falling, and values of any normalisation: table_problem is empty.
  PhaseTable(std::vector<double> cosines, std::vector<double> values);

  bool operator==(const PhaseTable&) const = default;
  double value(double mu) const;
  double moment(int degree) const;
  /// What the values were divided by: their integral over the sphere, by the trapezoid rule on the cosines.
  double integral() const { return integral_; }
  std::size_t size() const { return cosines_.size(); }
  const std::vector<double>& cosines() const { return cosines_; }  ///< rising
  const std::vector<double>& values() const { return values_; }    ///< [1/sr]

 private:
  double moment_by_quadrature(int degree) const;

  std::vector<double> cosines_;  ///< rising
  std::vector<double> values_;   ///< [1/sr]
  double integral_ = 0;
  std::vector<double> moments_;  ///< [degree], those that are asked for often
};
double value_of(const PhaseTable& phase, double mu);
double moment_of(const PhaseTable& phase, int degree);
std::string name_of(const PhaseTable& phase);

/// Why these make no phase function, and what is accepted; empty where they do.
std::string table_problem(const std::vector<double>& cosines, const std::vector<double>& values);

}  // namespace etendue
