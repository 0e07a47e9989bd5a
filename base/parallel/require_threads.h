// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Throws FileError where the system does not start so many threads, this one included: OpenMP would end the
/// program.
void require_threads(int count);

}  // namespace etendue
