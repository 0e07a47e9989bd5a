// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/gas_bands.h"

#include <fmt/format.h>

#include <optional>

#include "app/case/keys/resolve_path.h"
#include "app/case/values/gray_gases.h"
#include "app/case/values/k_distribution.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

bool is_sound(const Section& section, std::string_view name) { return !section.node().find(name)->faulty; }

std::optional<GrayGases> read_wsgg(Section& section, const std::optional<BandValues>& molar_ratio) {
  if (!is_sound(section, "wsgg")) return std::nullopt;
  const std::string model = section.text("wsgg");
  if (model != "bordbar") {
    section.unused("molar_ratio", fmt::format("{} is for one ratio", model));
    return smith_gases(model == "smith-1" ? 1 : 2);
  }
  if (!section.has("molar_ratio")) {
    section.fault("molar_ratio",
                  "missing; give that of water vapour to carbon dioxide, such as 2 for methane "
                  "and 1 for oil, burnt in air");
    return std::nullopt;
  }
  if (!molar_ratio || !is_sound(section, "molar_ratio")) return std::nullopt;
  const Value& ratio = molar_ratio->values.front();
  return bordbar_gases(is_number(ratio) ? std::get<double>(ratio) : 1);
}

std::optional<GrayGases> read_distribution(Section& section, const std::filesystem::path& case_folder) {
  section.unused("molar_ratio", "k_distribution is for one mixture");
  const TomlNode* node = section.find("k_distribution");
  if (node == nullptr) return std::nullopt;
  try {
    return k_distribution(readable_path(*node, case_folder));
  } catch (const InputError& error) {
    section.fault("k_distribution", "is no k-distribution: " + to_string(error.faults().front()));
    return std::nullopt;
  }
}

/// Gray gases begin with the clear one; the points of a k-distribution are all alike.
std::vector<std::string> gas_names(const GrayGases& mixture, bool first_is_clear) {
  std::vector<std::string> names;
  for (std::size_t gas = 0; gas < mixture.gases.size(); ++gas)
    names.push_back(first_is_clear && gas == 0 ? "clear"
                                               : fmt::format("gray-{}", first_is_clear ? gas : gas + 1));
  return names;
}

}  // namespace

Bands read_gas_bands(Section& section, const std::filesystem::path& case_folder,
                     const std::optional<BandValues>& molar_ratio) {
  const bool is_sum = section.has("wsgg");
  const char* key = is_sum ? "wsgg" : "k_distribution";
  for (const char* name : {"names", "edges"})
    if (section.has(name))
      section.fault(name, fmt::format("not beside {}, whose gray gases are the bands; leave it out", key));
  if (is_sum && section.has("k_distribution")) {
    section.fault("k_distribution", "not beside wsgg, which gives the bands too; use one of them");
    return {.names = {}, .edges = {}};
  }
  std::optional<GrayGases> mixture =
      is_sum ? read_wsgg(section, molar_ratio) : read_distribution(section, case_folder);
  if (!mixture) return {.names = {}, .edges = {}};
  return {.names = gas_names(*mixture, is_sum), .edges = {}, .gas = std::move(*mixture)};
}

}  // namespace etendue
