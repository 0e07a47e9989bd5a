// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/phase_text.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "solver/materials/kernels/kernel_profile.h"
#include "solver/transport/scattering/scattering_plan.h"

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

namespace {

std::string treatment_text(const ScatteringTreatment& how) {
  return how.is_dense() ? "by a matrix (" + how.reason + ")"
                        : fmt::format("by moments of degree {} ({})", how.degree, how.reason);
}

}  // namespace

std::vector<std::string> plan_texts(const Problem& problem, const DirectionSet& directions) {
  const std::vector<ScatteringTreatment> plan = plan_scattering(problem, directions);
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (!plan[i].is_dense() && plan[i].degree == 0) continue;
    const std::string how = treatment_text(plan[i]);
    std::string names = problem.bands().names[i % bands];
    while ((i + 1) % bands != 0 && treatment_text(plan[i + 1]) == how)
      names += ", " + problem.bands().names[++i % bands];
    texts.push_back(fmt::format("{}, {} {}: {}", problem.media()[i / bands].name,
                                names.find(',') == std::string::npos ? "band" : "bands", names, how));
  }
  return texts;
}

namespace {

/// 0, twenty to a decade up to 1 degree, and quarters of a degree.
std::vector<double> angles() {
  std::vector<double> degrees = {0};
  for (int i = 0; i < 60; ++i) degrees.push_back(0.001 * std::pow(10, i / 20.0));
  for (int i = 4; i <= 720; ++i) degrees.push_back(i / 4.0);
  return degrees;
}

/// Directions before scattering for which leaves, flakes and kernels are listed: down, aslant and level.
const std::vector<Vec3> shown_directions = {{0, 0, -1}, {0.6, 0, -0.8}, {1, 0, 0}};

void add_profiles(const std::string& name, const std::string& band, const DirectionalScattering& scattering,
                  std::string& text) {
  for (const Vec3& before : shown_directions) {
    const KernelProfile profile(scattering, before);
    if (!profile.is_known()) continue;
    // Straight ahead flakes have no value.
    for (int degrees = 1; degrees <= 180; ++degrees)
      text += fmt::format("{} from ({:g} {:g} {:g}),{},{},{:.9g}\n", name, before.x(), before.y(), before.z(),
                          band, degrees, profile(std::cos(degrees * std::numbers::pi / 180)));
  }
}

}  // namespace

std::string phase_values(const Case& input) {
  std::string text = "medium,band,degrees,p\n";
  for (const auto& [name, medium] : input.media)
    for (std::size_t band = 0; band < input.bands.names.size() && !medium.phase.empty(); ++band) {
      PhaseFunction phase = medium.phase[medium.phase.size() == 1 ? 0 : band];
      if (input.angular_space == AngularSpace::plane) phase = in_plane(phase);
      for (const double degrees : angles())
        text += fmt::format("{},{},{:.6g},{:.9g}\n", name, input.bands.names[band], degrees,
                            phase_value(phase, std::cos(degrees * std::numbers::pi / 180)));
    }
  for (const auto& [name, medium] : input.media)
    for (std::size_t band = 0; band < medium.directional.size(); ++band)
      add_profiles(name, input.bands.names[band], medium.directional[band], text);
  return text;
}

}  // namespace etendue
