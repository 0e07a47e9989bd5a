// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/heat/anderson_mixing.h"
#include "solver/heat/gray_diffusion.h"
#include "solver/heat/heat_balance.h"
#include "solver/heat/heat_solution.h"
#include "solver/solution/following_emission.h"

namespace etendue {

/// Finds the temperatures of media and walls from their heat: gray diffusion turns the heat that each gains
/// into changes of temperature, and the steps before speed these up. With one band and no scattering a step
/// is one sweep.
class TemperatureIteration : public FollowingEmission {
 public:
  /// The arguments must outlive it. Throws InputError where a medium whose temperature follows neither
  /// conducts nor absorbs, or nothing takes the heat of what conducts away.
  TemperatureIteration(const Problem& problem, const HeatProblem& heat);

  const FollowingSources& sources() const override { return sources_; }
  void set_unswept(const LightAtVertices& light) override { unswept_ = light; }
  double improve(const LightAtVertices& light) override;
  std::vector<double> state() const override { return values_; }
  void start_from(std::span<const double> state) override;
  std::string note() const override;

  HeatSolution solution() const;

 private:
  void check_media() const;
  void check_conductors() const;
  std::vector<double> temperatures() const;
  std::vector<double> wall_temperatures() const;
  double cells_per_layer() const;
  void set_sources();
  double limited(std::size_t unknown, double change, double highest) const;

  const Problem& problem_;
  TemperatureSpace space_;
  HeatBalance balance_;
  GrayDiffusion diffusion_;
  AndersonMixing mixing_;
  std::vector<double> values_;       ///< [unknown]
  std::vector<double> temperature_;  ///< [unknown] [K]
  Blackbodies blackbodies_;
  FollowingSources sources_;
  LightAtVertices unswept_;
  double change_ = 0;  ///< of the last step, relative
};

}  // namespace etendue
