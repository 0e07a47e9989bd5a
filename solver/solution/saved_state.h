// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

namespace etendue {

/// All that one sweep hands to the next (TransportState), without the padding of lanes: what a file keeps and
/// another run may start from. The band is the fastest index everywhere.
struct SavedState {
  int bands = 0;
  std::vector<double> fluence;       ///< [cell][node][band], 4 nodes, or 1 of constant elements
  std::vector<double> moments;       ///< [angular cell][moment][node][band]
  std::vector<double> irradiance;    ///< [boundary face][face node][band]
  std::vector<double> mirrors;       ///< [mirror face][pair of ordinates][face node][band]
  std::vector<double> lagged;        ///< [lagged face of all pairs][2 ordinates][face node][band]
  std::vector<double> radiance;      ///< [ordinate][dense cell][node][band] where scattering is by a matrix
  std::vector<double> photons = {};  ///< the sums of a run by photons, and nothing else then
  /// Whether the ordinates of mirrors, lagged faces and radiance may be turned: these are then taken only as
  /// far as they fit.
  bool is_turned = false;
  std::vector<double> following = {};  ///< FollowingEmission::state(), where an emission follows
};

}  // namespace etendue
