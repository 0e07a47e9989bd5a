// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/lamps/lamp_tilt.h"

#include <algorithm>

namespace etendue {

std::optional<double> LampTilt::factor_at(double degrees) const {
  constexpr double rounding = 1e-9;  // [degree]
  if (angle.empty()) return 1;
  if (degrees < angle.front() - rounding || degrees > angle.back() + rounding) return {};
  const double inside = std::clamp(degrees, angle.front(), angle.back());
  const auto next = static_cast<std::size_t>(std::ranges::lower_bound(angle, inside) - angle.begin());
  if (next == 0) return factor.front();
  const double part = (inside - angle[next - 1]) / (angle[next] - angle[next - 1]);
  return factor[next - 1] + part * (factor[next] - factor[next - 1]);
}

}  // namespace etendue
