// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

std::vector<SensorCase> read_sensors(Section& top);

}  // namespace etendue
