// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/text/vector_text.h"

#include <fmt/format.h>

namespace etendue {

std::string vector_text(const Vec3& vector) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", vector.x(), vector.y(), vector.z());
}

}  // namespace etendue
