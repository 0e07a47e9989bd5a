// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/geometry/primitives/exact.h"
#include "mesh/geometry/primitives/geometry.h"

namespace etendue {

/// A part of a sheet. Corners are those of the sheet to the last bit, so that edges which lie on others in
/// the file do so here; parts of a sheet with more than three corners are in one plane to rounding only.
struct SheetTriangle {
  std::array<ExactPoint, 3> corners;
  ExactPlane plane;
  int sheet;
};

/// The sheet, which must have no fault, in triangles between its corners.
std::vector<SheetTriangle> sheet_triangles(const Sheet& sheet, int number);

}  // namespace etendue
