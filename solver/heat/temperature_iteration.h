// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/heat/anderson_mixing.h"
#include "solver/heat/gray_diffusion.h"
#include "solver/heat/heat_balance.h"
#include "solver/heat/heat_solution.h"
#include "solver/heat/heat_storage.h"
#include "solver/solution/following_emission.h"
#include "solver/solution/solution.h"

namespace etendue {

/// An implicit stage of a step in time: heat H is stored so that
///
///     (H(T) - H(before) - stored) / length = heat that is gained at T.
struct HeatStage {
  double t = 0;                ///< its end, when sources have their factors [s]
  double length = 0;           ///< [s]
  std::vector<double> before;  ///< [unknown] temperatures at the begin of the step [K]
  std::vector<double> stored;  ///< [unknown] since then, of other stages [J]
};

/// Finds the temperatures of media and walls from their heat: gray diffusion turns the heat that each gains
/// into changes of temperature, and the steps before speed these up. With one band and no scattering a step
/// is one sweep.
class TemperatureIteration : public FollowingEmission {
 public:
  /// The arguments must outlive it. Throws InputError where a medium whose temperature follows neither
  /// conducts nor absorbs nor holds heat, or nothing takes the heat of what conducts away and is steady.
  TemperatureIteration(const Problem& problem, const HeatProblem& heat);

  const FollowingSources& sources() const override { return sources_; }
  void set_unswept(const LightAtVertices& light) override { unswept_ = light; }
  double improve(const LightAtVertices& light) override;
  /// [unknown] Temperatures [K].
  std::vector<double> state() const override { return temperature_; }
  void start_from(std::span<const double> state) override;
  std::string note() const override;

  HeatSolution solution() const;

  /// From now on temperatures are those of a stage; they begin from the last ones.
  void set_stage(HeatStage stage);
  const HeatStorage& storage() const { return storage_; }
  const std::vector<double>& temperature() const { return temperature_; }  ///< [unknown] [K]
  /// Heat that all unknowns together gain by a solution but do not store [W]: the iteration leaves it.
  double missing_heat(const Solution& solution) const;

 private:
  std::vector<double> residual(const LightAtVertices& light) const;
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
  HeatStorage storage_;
  std::optional<HeatStage> stage_;  ///< none: what is steady
  AndersonMixing mixing_;
  std::vector<double> values_;       ///< [unknown]
  std::vector<double> temperature_;  ///< [unknown] [K]
  Blackbodies blackbodies_;
  FollowingSources sources_;
  LightAtVertices unswept_;
  double change_ = 0;  ///< of the last step, relative
};

}  // namespace etendue
