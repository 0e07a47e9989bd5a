// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include <etendue/case.h>

#include "app/case/case.h"

namespace etendue::v0 {

struct Case::Impl {
  etendue::Case input;
  std::optional<Mesh> mesh;  ///< that was given
};

}  // namespace etendue::v0
