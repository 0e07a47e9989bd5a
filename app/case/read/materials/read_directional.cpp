// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_directional.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/case/keys/resolve_path.h"
#include "app/case/values/band_values.h"
#include "base/text/number_columns.h"
#include "solver/materials/kernels/micro_flakes.h"

namespace etendue {
namespace {

/// Keys that leaves, flakes and kernels leave no room for.
void refuse_keys(Section& section, std::initializer_list<const char*> names, const std::string& why) {
  for (const char* name : names) section.unused(name, why);
}

/// A density times a part of it.
Value part_of(const Value& density, double part) {
  if (const double* number = std::get_if<double>(&density)) return *number * part;
  Formula formula = std::get<Formula>(density);
  formula.text = fmt::format("({})*{:.17g}", formula.text, part);
  return formula;
}

BandValues required_density(Section& section, const char* name, const Bands& bands) {
  if (auto values = read_band_values(section, name, bands)) return *values;
  if (!section.has(name)) section.fault(name, "missing; use a number or a formula in x, y, z");
  return {{0.0}, section.origin()};
}

double number_in(const BandValues& values, int band) { return std::get<double>(value_of(values, band)); }

/// What is absorbed and scattered of a density in the mean over directions.
void set_means(MediumCase& medium, const BandValues& density, const std::vector<double>& absorbed,
               const std::vector<double>& scattered) {
  medium.absorption = BandValues{{}, density.origin};
  medium.scattering = BandValues{{}, density.origin};
  for (std::size_t band = 0; band < absorbed.size(); ++band) {
    const Value& value = value_of(density, static_cast<int>(band));
    medium.absorption->values.push_back(part_of(value, absorbed[band]));
    medium.scattering->values.push_back(part_of(value, scattered[band]));
  }
}

void read_leaves(Section leaves, const Bands& bands, MediumCase& medium) {
  const BandValues density = required_density(leaves, "area_density", bands);
  const std::string angles = leaves.text("angles");
  const BandValues reflectance = read_band_values_or_default(leaves, "reflectance", bands);
  const BandValues transmittance = read_band_values_or_default(leaves, "transmittance", bands);
  const auto& names = leaf_angle_names();
  const auto found = std::ranges::find(names, angles);
  std::vector<double> absorbed, scattered;
  for (int band = 0; band < bands.count(); ++band) {
    const double back = number_in(reflectance, band), through = number_in(transmittance, band);
    if (back + through > 1)
      leaves.fault(fmt::format("reflectance + transmittance = {} (a leaf would make light); use at most 1",
                               back + through));
    const auto kind =
        found == names.end() ? LeafAngles::spherical : static_cast<LeafAngles>(found - names.begin());
    medium.directional.emplace_back(LeafCanopy{kind, back, through});
    absorbed.push_back(0.5 * (1 - back - through));
    scattered.push_back(0.5 * (back + through));
  }
  set_means(medium, density, absorbed, scattered);
}

void read_flakes(Section flakes, const Bands& bands, MediumCase& medium) {
  const BandValues density = required_density(flakes, "density", bands);
  const Vec3 axis = flakes.point_if("axis").value_or(Vec3::UnitZ());
  if (axis.norm() == 0) flakes.fault("axis", "has no direction; use a vector that is not zero");
  MicroFlakes shape;
  shape.axis = axis.norm() == 0 ? Vec3::UnitZ() : Vec3(axis.normalized());
  shape.along = flakes.number("along");
  shape.across = flakes.number("across");
  const BandValues albedo = read_band_values_or_default(flakes, "albedo", bands);
  std::vector<double> absorbed, scattered;
  for (int band = 0; band < bands.count(); ++band) {
    shape.albedo = number_in(albedo, band);
    medium.directional.emplace_back(shape);
    absorbed.push_back(mean_flake_projection(shape) * (1 - shape.albedo));
    scattered.push_back(mean_flake_projection(shape) * shape.albedo);
  }
  set_means(medium, density, absorbed, scattered);
}

/// Whether all numbers are those of ordinates; what is wrong becomes a fault.
bool are_ordinates(Section& section, const std::vector<double>& numbers, int ordinates) {
  for (const double number : numbers) {
    if (number >= 0 && number < ordinates && number == std::floor(number)) continue;
    section.fault("kernel",
                  fmt::format("its file names the ordinate {}; use whole numbers from 0 to {}, those of the "
                              "case's own directions",
                              number, ordinates - 1));
    return false;
  }
  return true;
}

/// Lines of from, into, k, with the numbers of ordinates.
KernelMatrix read_matrix(Section& section, const TomlNode& file, const MatterContext& context) {
  KernelMatrix matrix;
  try {
    const auto columns = read_columns(readable_path(file, context.case_folder), {"from", "into", "k"});
    // A matrix is allocated only for directions that there are.
    const int ordinates = context.ordinates();
    if (columns[0].empty() || ordinates == 0) return matrix;
    if (!are_ordinates(section, columns[0], ordinates) || !are_ordinates(section, columns[1], ordinates))
      return matrix;
    for (const auto& column : {columns[0], columns[1]})
      matrix.count = std::max(matrix.count, static_cast<int>(*std::ranges::max_element(column)) + 1);
    const auto count = static_cast<std::size_t>(matrix.count);
    matrix.values.assign(count * count, 0);
    std::vector<bool> given(count * count);
    for (std::size_t i = 0; i < columns[0].size(); ++i) {
      const auto from = static_cast<std::size_t>(columns[0][i]),
                 into = static_cast<std::size_t>(columns[1][i]);
      if (given[from * count + into]) {
        section.fault("kernel", fmt::format("its file has two values from {} into {}; use one", from, into));
        return matrix;
      }
      given[from * count + into] = true;
      matrix.values[from * count + into] = columns[2][i];
    }
  } catch (const InputError& error) {
    section.faults().insert(section.faults().end(), error.faults().begin(), error.faults().end());
  }
  return matrix;
}

/// One number for all bands; else the medium keeps what is given.
std::optional<double> constant_extinction(Section& section, const Bands& bands, MediumCase& medium) {
  const auto values = read_band_values(section, "extinction", bands, FormulaOf::place_and_direction);
  if (!values) return std::nullopt;
  if (values->values.size() == 1 && std::holds_alternative<double>(values->values.front()))
    return std::get<double>(values->values.front());
  medium.kernel_extinction = *values;
  return std::nullopt;
}

void read_kernel(Section& section, const MatterContext& context, MediumCase& medium) {
  const TomlNode& node = *section.find("kernel");
  const std::optional<double> extinction = constant_extinction(section, context.bands, medium);
  if (section.has("extinction"))
    section.unused("absorption", "extinction says what the kernel does not scatter");
  else
    medium.absorption =
        read_band_values_or_default(section, "absorption", context.bands, FormulaOf::place_and_direction);
  DirectionalScattering kernel;
  if (node.is_text()) {
    KernelFormula formula;
    formula.reciprocal = section.boolean("reciprocal");
    formula.extinction = extinction;
    try {
      formula.formula = std::make_shared<Expression>(node.text(), kernel_variables());
    } catch (const InputError& error) {
      section.fault("kernel", "is not a formula (" + error.faults().front().text + ")");
      return;
    }
    kernel = formula;
  } else {
    const TomlNode* file = node.is_table() ? node.find("file") : nullptr;
    if (file == nullptr || !file->is_text() || node.table().entries.size() != 1) {
      section.fault("kernel", "is no kernel; use a formula or { file = \"k.csv\" }");
      return;
    }
    KernelMatrix matrix = read_matrix(section, *file, context);
    matrix.reciprocal = section.boolean("reciprocal");
    matrix.extinction = extinction;
    kernel = matrix;
  }
  medium.has_kernel = true;
  medium.directional.assign(static_cast<std::size_t>(context.bands.count()), kernel);
}

}  // namespace

bool is_directional(const Section& section) {
  return section.has("leaves") || section.has("flakes") || section.has("kernel");
}

void read_directional(Section& section, const MatterContext& context, MediumCase& medium) {
  const int kinds =
      (section.has("leaves") ? 1 : 0) + (section.has("flakes") ? 1 : 0) + (section.has("kernel") ? 1 : 0);
  if (kinds > 1) section.fault("leaves, flakes and a kernel in one region; use one of them");
  refuse_keys(section,
              {"scattering", "reduced_scattering", "albedo", "phase", "scattering_method",
               "scattering_degree", "forward_peak"},
              "the leaves, flakes or kernel say it");
  if (!section.has("kernel")) {
    refuse_keys(section, {"absorption", "extinction"}, "the leaves or flakes say it");
    section.unused("reciprocal", "leaves and flakes are");
  }
  if (context.space == AngularSpace::plane)
    section.fault("leaves, flakes and kernels are those of space; use another direction set than flatland");
  if (section.has("leaves"))
    read_leaves(section.section("leaves"), context.bands, medium);
  else if (section.has("flakes"))
    read_flakes(section.section("flakes"), context.bands, medium);
  else
    read_kernel(section, context, medium);
}

}  // namespace etendue
