// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "app/study/study.h"
#include "app/study/study_trust.h"

namespace etendue {
namespace {

using Json = nlohmann::ordered_json;

/// RFC 4180.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string number_or_empty(const std::optional<double>& value) {
  return value ? fmt::to_string(*value) : "";
}
Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// Where both are refined there is no size that errors could be drawn against.
std::optional<double> size_of(const StudyRow& row, Refinement refinement) {
  if (refinement == Refinement::both) return std::nullopt;
  return refined_size(*row.level, refinement);
}

Json row_json(const StudyRow& row, Refinement refinement) {
  return {{"level", row.level->level},
          {"refined", name_of(refinement)},
          {"cells", row.level->cells},
          {"h", row.level->size},
          {"directions", row.level->directions},
          {"size", or_null(size_of(row, refinement))},
          {"band", row.value->band},
          {"quantity", row.value->quantity},
          {"value", row.value->value},
          {"reference", name_of(row.reference)},
          {"error", or_null(row.error)},
          {"iteration", or_null(row.iteration)},
          {"order", or_null(row.order)},
          {"sweeps", row.level->sweeps},
          {"seconds", row.level->seconds},
          {"memory", row.level->memory},
          {"converged", row.level->converged}};
}

}  // namespace

std::string study_csv(const std::vector<StudyRow>& rows, Refinement refinement) {
  std::string csv = "level,refined,cells,h,directions,band,quantity,value,error,order,sweeps,seconds\n";
  for (const StudyRow& row : rows)
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{},{},{},{}\n", row.level->level,
                   name_of(refinement), row.level->cells, row.level->size, row.level->directions,
                   quoted(row.value->band), quoted(row.value->quantity), row.value->value,
                   number_or_empty(row.error), number_or_empty(row.order), row.level->sweeps,
                   row.level->seconds);
  return csv;
}

std::string study_json(const std::vector<StudyRow>& rows, Refinement refinement, const Case& input,
                       const std::vector<StudyFailure>& failures, const std::vector<StudyTrust>& trust) {
  Json json = {{"title", input.title}, {"refined", name_of(refinement)}, {"rows", Json::array()}};
  if (input.exact && input.exact->family && refinement == Refinement::mesh)
    json["expected_order"] =
        or_null(expected_order(*input.exact->family, static_cast<int>(input.solve.order)));
  json["failed"] = Json::array();
  for (const StudyFailure& failure : failures)
    json["failed"].push_back({{"level", failure.level}, {"problem", failure.problem}});
  json["richardson"] = Json::array();
  for (const StudyLimit& limit : study_limits(rows, refinement))
    json["richardson"].push_back({{"band", limit.finest->band},
                                  {"quantity", limit.finest->quantity},
                                  {"value", limit.of.value},
                                  {"order", limit.of.order}});
  json["trust"] = Json::array();
  for (const StudyTrust& entry : trust)
    json["trust"].push_back({{"band", entry.value->band},
                             {"quantity", entry.value->quantity},
                             {"value", entry.value->value},
                             {"error", entry.error},
                             {"from", name_of(entry.basis)}});
  for (const StudyRow& row : rows) json["rows"].push_back(row_json(row, refinement));
  json["case"] = input.resolved_toml;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace etendue
