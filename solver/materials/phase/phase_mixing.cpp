// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_mixing.h"

#include <stdexcept>

namespace etendue {
namespace {

struct ToMixture {
  PhaseMixture operator()(const PhaseMixture& mixture) const { return mixture; }
  PhaseMixture operator()(const PhaseDoubleHenyeyGreenstein& two) const {
    return {{two.weight, 1 - two.weight},
            {PhaseHenyeyGreenstein{two.first}, PhaseHenyeyGreenstein{two.second}}};
  }
  PhaseMixture operator()(const PhasePlane&) const {
    throw std::invalid_argument("phase functions of the plane are mixed before they are made");
  }
  PhaseMixture operator()(const PhasePart& part) const { return {{1}, {part}}; }
};

}  // namespace

PhaseFunction with_isotropic_part(const PhaseFunction& phase, double share) {
  if (std::holds_alternative<PhaseIsotropic>(phase) || share == 0) return phase;
  if (share == 1) return PhaseIsotropic{};
  PhaseMixture mixture = std::visit(ToMixture{}, phase);
  for (double& part : mixture.shares) part *= 1 - share;
  mixture.shares.push_back(share);
  mixture.parts.emplace_back(PhaseIsotropic{});
  return mixture;
}

}  // namespace etendue
