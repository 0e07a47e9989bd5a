// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_glossy.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "app/case/keys/resolve_path.h"
#include "app/case/values/band_values.h"
#include "base/text/number_columns.h"
#include "solver/materials/surfaces/microfacets.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/materials/surfaces/reflectance_table.h"
#include "solver/materials/surfaces/ward.h"

namespace etendue {
namespace {

/// Makes the model of a reflectance, or of a factor.
using Maker = std::function<std::shared_ptr<const Reflectance>(double)>;

constexpr const char* glossy_path = "walls.NAME.glossy";

std::optional<double> needed(Section& section, const char* key) {
  if (!section.has(key)) section.fault(key, "missing; use " + accepted_text(*find_key(glossy_path, key)));
  return section.number_if(key);
}

std::vector<ReflectancePoint> points_of(Section& section, const std::filesystem::path& case_folder) {
  if (!section.has("file"))
    section.fault("file",
                  "missing; use the name of a CSV file of angle_in, angle_out, azimuth [degree] and value "
                  "[1/sr]");
  const TomlNode* file = section.find("file");
  if (file == nullptr) return {};
  try {
    const auto columns =
        read_columns(readable_path(*file, case_folder), {"angle_in", "angle_out", "azimuth", "value"});
    std::vector<ReflectancePoint> points;
    for (std::size_t i = 0; i < columns[0].size(); ++i)
      points.push_back({columns[0][i], columns[1][i], columns[2][i], columns[3][i]});
    const std::string problem = ReflectanceTable::problem_of(points);
    if (problem.empty()) return points;
    section.fault("file", problem);
  } catch (const InputError& error) {
    const std::vector<Fault>& faults = error.faults();
    section.faults().insert(section.faults().end(), faults.begin(), faults.end());
  }
  return {};
}

/// Empty where something is faulty. Keys of other models are faults.
Maker read_model(Section& section, const std::filesystem::path& case_folder) {
  const std::string model = section.text_if("model").value_or("");
  const std::pair<const char*, std::vector<std::string>> owners[] = {
      {"exponent", {"phong"}}, {"roughness", {"ggx", "ward"}}, {"fresnel", {"ggx"}}, {"file", {"table"}}};
  for (const auto& [key, models] : owners)
    if (std::ranges::find(models, model) == models.end())
      section.unused(key, fmt::format("it belongs to model = \"{}\"", fmt::join(models, "\" or \"")));
  if (model == "phong") {
    const std::optional<double> exponent = needed(section, "exponent");
    if (!exponent) return {};
    return [exponent](double r) { return std::make_shared<Phong>(r, *exponent); };
  }
  if (model == "ggx") {
    const std::optional<double> roughness = needed(section, "roughness");
    const FacetFresnel fresnel =
        section.text("fresnel") == "schlick" ? FacetFresnel::schlick : FacetFresnel::constant;
    if (!roughness) return {};
    return [roughness, fresnel](double r) { return std::make_shared<Microfacets>(r, *roughness, fresnel); };
  }
  if (model == "ward") {
    const std::optional<double> roughness = needed(section, "roughness");
    if (!roughness) return {};
    return [roughness](double r) { return std::make_shared<Ward>(r, *roughness); };
  }
  if (model != "table") return {};
  std::vector<ReflectancePoint> points = points_of(section, case_folder);
  if (points.empty()) return {};
  return [points](double factor) { return std::make_shared<ReflectanceTable>(points, factor); };
}

}  // namespace

std::vector<std::shared_ptr<const Reflectance>> read_glossy(Section glossy, const Bands& bands,
                                                            const std::filesystem::path& case_folder) {
  const Maker make = read_model(glossy, case_folder);
  const BandValues reflectance = read_band_values_or_default(glossy, "reflectance", bands);
  std::vector<std::shared_ptr<const Reflectance>> models;
  if (!make) return models;
  std::map<double, std::shared_ptr<const Reflectance>> made;
  for (int band = 0; band < bands.count(); ++band) {
    const double value = std::get<double>(value_of(reflectance, band));
    auto& model = made[value];
    if (value > 0 && model == nullptr) model = make(value);
    models.push_back(model);
  }
  return models;
}

}  // namespace etendue
