// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "app/render/pictures.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/observe/photon_map/keep_hits.h"

namespace etendue {

/// Throws InputError with each camera that a photon map cannot serve.
void check_photon_cameras(const std::vector<CameraCase>& cameras, const Problem& problem);

/// Of the photon map of a case; 0 without cameras.
HitMemory estimate_photon_map_memory(const Case& input, const Problem& problem, int threads);

/// Walks the histories of the photon map, says what is in it, and writes the pictures that it shows. False
/// where it was interrupted.
bool write_photon_pictures(const PictureOrder& order, const Problem& problem, const CellLocator& locator,
                           int threads);

}  // namespace etendue
