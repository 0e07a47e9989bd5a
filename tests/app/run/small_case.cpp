// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/app/run/small_case.h"

#include <algorithm>
#include <sstream>

namespace etendue::test {

std::string small_case() {
  return R"(title = "Small"
[mesh]
max_volume = 0.02
[[mesh.box]]
region = "smoke"
min = [0, 0, 0]
max = [1, 1, 1]
walls = { zmin = "floor" }
[bands]
names = ["red", "green", "blue"]
[media.smoke]
absorption = [0.1, 0.2, 0.3]
scattering = 1.0
[walls.floor]
radiance = [1.0, 0.8, 0.6]
[walls."*"]
diffuse = 0.5
[directions]
set = "product"
order = 2
[[probe]]
name = "middle"
points = [[0.5, 0.5, 0.5]]
normal = [0, 0, 1]
[output]
directory = "results"
)";
}

Outcome etendue_says(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  std::vector<std::string> words = arguments;
  const auto names_estimate = [](const std::string& word) { return word.ends_with("-estimate"); };
  if (!words.empty() && words.front() == "run" && std::ranges::none_of(words, names_estimate))
    words.push_back("--no-estimate");
  const ExitCode code = run_command(words, out, err);
  return {code, out.str(), err.str()};
}

CaseFolder::CaseFolder(const std::string& text) { write_text(file(), text); }

}  // namespace etendue::test
