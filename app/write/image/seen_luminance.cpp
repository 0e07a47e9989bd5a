// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/seen_luminance.h"

namespace etendue {

SeenLuminance::SeenLuminance(const Case& input) : photometry_(input.bands) {
  const SiScale scale = si_scale(input.units.length, input.units.power).value();
  scale_ = scale.power / (scale.length * scale.length);
  meters_ = scale.length;
}

}  // namespace etendue
