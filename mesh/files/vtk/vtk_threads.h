// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// From now on VTK works without threads in this process, to be called before anything is read or written.
/// What a damaged file could break is read in a child process, where threads of the parent do not live on:
/// VTK would wait for them, and a lock that one of them held is held for ever.
void use_vtk_without_threads();

}  // namespace etendue
