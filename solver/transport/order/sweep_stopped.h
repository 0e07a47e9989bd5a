// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Thrown where SolveOptions::stops ended a sweep in its midst, or the making of its orders. What it was to
/// give is of no use, and the sweep must not be made again.
struct SweepStopped {};

}  // namespace etendue
