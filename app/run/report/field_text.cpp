// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/field_text.h"

#include <fmt/format.h>

#include "app/case/build/field_uses.h"

namespace etendue {
namespace {

std::string unit_of(const std::string& key, const Units& units) {
  if (key == "albedo") return "";
  if (key == "emission") return fmt::format(" {}/({}^3 sr)", units.power, units.length);
  if (key == "power_density") return fmt::format(" {}/{}^3", units.power, units.length);
  if (key == "radiance") return fmt::format(" {}/({}^2 sr)", units.power, units.length);
  return fmt::format(" 1/{}", units.length);
}

}  // namespace

std::vector<std::string> field_texts(const Case& input, const TetrahedralMesh& mesh) {
  std::vector<std::string> texts;
  for (const FieldUse& use : field_uses(input, mesh))
    texts.push_back(fmt::format("{} of {}: {}, from {:.6g} to {:.6g}, mean {:.6g}{}", use.key, use.place,
                                use.field, use.smallest, use.largest, use.mean,
                                unit_of(use.key, input.units)));
  return texts;
}

}  // namespace etendue
