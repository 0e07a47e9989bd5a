// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/phase_text.h"

#include <fmt/format.h>

namespace etendue {

std::vector<std::string> phase_texts(const Case& input) {
  std::vector<std::string> texts;
  for (const auto& [name, medium] : input.media) {
    for (const std::string& note : medium.phase_notes) texts.push_back(name + ": " + note);
    for (std::size_t band = 0; band < medium.phase.size(); ++band) {
      if (std::holds_alternative<PhaseIsotropic>(medium.phase[band])) continue;
      const std::string in_band =
          medium.phase.size() == 1 ? "" : fmt::format(" (band {})", input.bands.names[band]);
      texts.push_back(fmt::format("{}{}: {}", name, in_band, phase_name(medium.phase[band])));
    }
  }
  return texts;
}

}  // namespace etendue
