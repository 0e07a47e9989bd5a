// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_false_color.h"

#include "app/case/keys/case_tables.h"

namespace etendue {

FalseColor read_false_color(Section section) {
  FalseColor color;
  false_color_table().read(section, color);
  if (color.logarithmic && color.least == 0.0)
    section.fault("min", "a logarithmic scale does not reach 0; use a number above 0");
  else if (color.least && color.most && *color.least >= *color.most)
    section.fault("min", "is not below max; use a smaller number");
  return color;
}

}  // namespace etendue
