// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/field_value.h"

#include <fmt/format.h>

#include <memory>

#include "app/case/keys/keys.h"
#include "app/case/keys/resolve_path.h"
#include "app/case/keys/section.h"
#include "mesh/files/fields/field_file.h"
#include "solver/materials/media/sampled_field.h"

namespace etendue {
namespace {

std::filesystem::path beside_case(const TomlNode& file) {
  return resolve_path(file, std::filesystem::path(file.origin.file).parent_path());
}

FieldRequest request_of(Section& field, const std::filesystem::path& path) {
  FieldRequest request{.path = path, .array = field.text_if("array").value_or("")};
  if (const auto on = field.text_if("on"))
    request.on = *on == "cells" ? FieldValues::on_cells : FieldValues::on_points;
  if (const auto component = field.number_if("component")) request.component = static_cast<int>(*component);
  request.time = field.number_if("time");
  return request;
}

void scale(FieldData& data, double value, double length) {
  for (double& number : data.values) number *= value;
  for (Vec3& point : data.points) point *= length;
  if (!data.image) return;
  data.image->origin *= length;
  data.image->steps *= length;
}

}  // namespace

std::optional<Formula> read_field_value(TomlNode& table, const std::string& function, Faults& faults) {
  Section field(table, std::string(field_table), faults);
  const TomlNode* file = field.find("file");
  const double factor = field.number("scale"), length = field.number("length_scale");
  const std::optional<double> outside = field.number_if("outside");
  if (file == nullptr) return std::nullopt;
  const FieldRequest request = request_of(field, beside_case(*file));
  const std::string name = request.array.empty() ? request.path.filename().string()
                                                 : request.array + " of " + request.path.filename().string();
  try {
    FieldData data = read_field(request);
    scale(data, factor, length);
    return Formula(fmt::format("{}(x,y,z)", function),
                   {{function, std::make_shared<SampledField>(name, std::move(data), outside,
                                                              FieldSource{request.path.string(), length})}});
  } catch (const InputError& error) {
    field.fault("file", error.faults().front().text);
  } catch (const FileError& error) {
    field.fault("file", error.what());
  }
  return std::nullopt;
}

}  // namespace etendue
