// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

constexpr double square(double x) { return x * x; }

}  // namespace etendue
