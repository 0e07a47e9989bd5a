// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/request/command_text.h"

#include <sstream>

namespace etendue {

const char* const command_examples = R"(Examples:
  etendue new room
  etendue run cases/smoke-room/case.toml
  etendue run case.toml --set solve.tolerance=1e-8 --set directions.order=2 --output fine
  etendue render smoke-room --camera front
  etendue bake smoke-room --quantity radiosity
  etendue study case.toml --refine mesh --levels 3
  etendue compare case.toml --methods ordinates,photons
  etendue adjoint case.toml --of sensor:desk --of wall:floor
  etendue check case.toml --mesh
  etendue mesh case.toml -o mesh.vtu
  etendue directions --set ldfe-sq --order 2 -o set.vtp
  etendue keys walls.floor
  etendue keys --schema > etendue.schema.json

Exit codes: 0 done, converged and balanced; 1 not converged or not balanced (results written and
marked so); 2 the case, the mesh or the command line is wrong; 3 a file could not be read or written;
4 internal error; 130 interrupted.)";

std::string examples_of(const std::string& command) {
  std::string text = "Examples:";
  std::istringstream lines(command_examples);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  etendue " + command + " ")) text += "\n" + line;
  return text;
}

std::string whole_number(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? "" : text + " is not a number of threads; use a whole number, 0 for all cores";
}

}  // namespace etendue
