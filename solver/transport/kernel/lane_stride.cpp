// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/kernel/sweep_kernel.h"

namespace etendue {

int lane_stride(int bands) {
  if (bands <= 2) return bands;
  if (bands <= 4) return 4;
  return (bands + 7) / 8 * 8;
}

}  // namespace etendue
