// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/run/small_case.h"

namespace etendue::test {

/// A unit cube that scatters, with an exact solution.
inline std::string exact_case(const std::string& more = "") {
  return R"([mesh]
max_volume = 0.05
[[mesh.box]]
region = "medium"
min = [0, 0, 0]
max = [1, 1, 1]
[media.medium]
absorption = 0.5
scattering = 1.0
[walls."*"]
[exact]
radiance = "3 + sin(2*x)*wx + cos(y + z)*wy^2"
[directions]
set = "product"
order = 2
[space]
lumping = "none"
[solve]
tolerance = 1e-8
[[probe]]
name = "middle"
points = [[0.5, 0.4, 0.3]]
[output]
directory = "results"
)" + more;
}

inline std::vector<std::string> study_of(const std::string& file, const std::string& refine, int levels) {
  return {"study",      file,   "--refine", refine, "--levels", std::to_string(levels),
          "--progress", "none", "--no-plot"};
}

inline nlohmann::json study_in(const CaseFolder& folder) {
  return nlohmann::json::parse(text_of(folder.path() / "results/study.json"));
}

inline std::vector<nlohmann::json> rows_of(const nlohmann::json& study, const std::string& quantity) {
  std::vector<nlohmann::json> rows;
  for (const nlohmann::json& row : study["rows"])
    if (row["quantity"] == quantity) rows.push_back(row);
  return rows;
}

}  // namespace etendue::test
