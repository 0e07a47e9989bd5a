// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_function.h"

#include <fmt/format.h>

namespace etendue {

double value_of(const PhaseMixture& phase, double mu) {
  double sum = 0;
  for (std::size_t i = 0; i < phase.parts.size(); ++i)
    sum +=
        phase.shares[i] * std::visit([mu](const auto& part) { return value_of(part, mu); }, phase.parts[i]);
  return sum;
}

double moment_of(const PhaseMixture& phase, int degree) {
  double sum = 0;
  for (std::size_t i = 0; i < phase.parts.size(); ++i)
    sum += phase.shares[i] *
           std::visit([degree](const auto& part) { return moment_of(part, degree); }, phase.parts[i]);
  return sum;
}

std::string name_of(const PhaseMixture& phase) {
  std::string text = "mixture of ";
  for (std::size_t i = 0; i < phase.parts.size(); ++i)
    text += fmt::format("{}{:.4g} ({})", i == 0 ? "" : " + ", phase.shares[i],
                        std::visit([](const auto& part) { return name_of(part); }, phase.parts[i]));
  return text;
}

PhaseFunction in_plane(const PhaseFunction& phase) {
  struct ToPlane {
    PhaseFunction operator()(const PhasePlane& plane) const { return plane; }
    PhaseFunction operator()(const PhaseMixture& mixture) const {
      return PhasePlane(mixture.shares, mixture.parts);
    }
    PhaseFunction operator()(const PhaseDoubleHenyeyGreenstein& two) const {
      return PhasePlane({two.weight, 1 - two.weight},
                        {PhaseHenyeyGreenstein{two.first}, PhaseHenyeyGreenstein{two.second}});
    }
    PhaseFunction operator()(const PhasePart& part) const { return PhasePlane({1}, {part}); }
  };
  return std::visit(ToPlane{}, phase);
}

double phase_value(const PhaseFunction& phase, double mu) {
  return std::visit([mu](const auto& model) { return value_of(model, mu); }, phase);
}

double phase_moment(const PhaseFunction& phase, int degree) {
  return std::visit([degree](const auto& model) { return moment_of(model, degree); }, phase);
}

double phase_asymmetry(const PhaseFunction& phase) { return phase_moment(phase, 1); }

std::string phase_name(const PhaseFunction& phase) {
  return std::visit([](const auto& model) { return name_of(model); }, phase);
}

}  // namespace etendue
