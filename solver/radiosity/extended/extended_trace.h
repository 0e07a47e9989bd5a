// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/radiosity/extended/extended_paths.h"
#include "solver/radiosity/extended/sparse_rows.h"

namespace etendue {

/// Exchange by rays that leave all patches, [patch left][patch met]: sums of the area that a ray
/// stands for, times its weight, and times by how much a wall redirects more of it than of isotropic light.
/// The latter are empty where no wall redirects by the angle.
struct TracedRays {
  struct Sums {
    explicit Sums(std::size_t stored) : light(stored), more_where_left(stored), more_where_met(stored) {}

    SparseRows light;
    SparseRows more_where_left;  ///< the wall of the patch left, of light that comes back along the ray
    SparseRows more_where_met;
  };
  /// Of first meetings, which are straight paths, `light` is there only where a wall redirects by the angle.
  Sums straight, extended;
};

/// Sends `rays` from each patch, even over its area and as the cosine. `stored` is the number of bands, or 1
/// where all bands are alike. The same for any number of threads.
TracedRays trace_rays(const Problem& problem, const WallPatches& patches, const ExtendedPaths& paths,
                      int rays, std::size_t stored, int threads);

/// Bytes that they take, about, with what is made of them; 0 where no wall redirects.
std::size_t bytes_of_traced_rays(const Problem& problem, std::size_t patches, int rays);

}  // namespace etendue
