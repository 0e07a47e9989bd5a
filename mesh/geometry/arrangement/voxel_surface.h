// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <Eigen/Dense>

#include "base/errors.h"
#include "base/field_data.h"
#include "mesh/geometry/arrangement/elementary_boxes.h"
#include "mesh/geometry/primitives/surface_complex.h"

namespace etendue {

/// The surfaces of voxels in the image's own axes, where its planes are exact: x is a step along the first
/// index, from the image's corner. In space a point is at `origin + axes x`.
struct VoxelSurface {
  SurfaceComplex surface;
  Eigen::Matrix3d axes;  ///< columns: unit vectors along the steps
  Vec3 origin;           ///< [length] of the corner
};

/// The surfaces of the voxels of an image by their labels. `labels` has the label of each region; voxels with
/// another one are left out. The sides of the image become the walls xmin … zmax, by the axis of space that
/// they look along most, and what borders on voxels left out becomes the wall "surface". The values of points
/// are taken for those of voxels around them. Throws InputError where a value is not a whole number or a
/// label belongs to no voxel; `origin` is that of the image in the case.
VoxelSurface voxel_surface(const FieldData& image, const std::map<std::string, int>& labels,
                           const Origin& origin, FacetSize size = FacetSize::largest);

}  // namespace etendue
