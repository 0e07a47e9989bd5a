// SPDX-License-Identifier: AGPL-3.0-or-later
//
// After test cases of CIE 171:2006 (Test cases to assess the accuracy of lighting computer programs) that
// have analytical answers; rooms are other ones where the report's are not needed for the answer.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>

#include "tests/app/readings/sensor_table.h"
#include "tests/app/run/box_case.h"
#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::cie171_test {
namespace {

using std::numbers::pi;
using test::box_case;
using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::Outcome;
using test::rows_of;
using test::text_of;

// 5.8, internal reflected component: a cube of 4 m with a lamp of 10,000 lm in its middle and the same
// diffuse reflectance everywhere. The mean indirect illuminance is Phi rho/(S (1 - rho)): 104.17 lx for 0.5,
// 416.67 lx for 0.8.
TEST(Cie171, InternalReflectedComponent) {
  for (const auto& [reflectance, indirect] : {std::pair{0.5, 104.17}, {0.8, 416.67}}) {
    const CaseFolder folder(
        box_case({.size = "[4, 4, 4]",
                  .edge_length = 2,
                  .bands = "names = [\"light\"]\nedges = [550, 560]",
                  .order = 4},
                 fmt::format("[walls.\"*\"]\ndiffuse = {}\n", reflectance) +
                     "[[light]]\nkind = \"point\"\nname = \"lamp\"\nposition = [2, 2, 2]\npower = 10000\n"
                     "[solve]\ntolerance = 1e-8\n"));
    const Outcome run = etendue_says({"run", folder.file()});
    ASSERT_EQ(run.code, ExitCode::done) << run.err;
    double incoming = 0;
    for (const double wall : CsvTable(text_of(folder.path() / "results" / "walls.csv")).numbers("incoming"))
      incoming += wall;
    EXPECT_NEAR((incoming - 10000) / 96, indirect, 1e-3 * indirect) << reflectance;
  }
}

/// A black room with one open wall under the CIE overcast sky of Moon and Spencer (1942), and points on its
/// floor along its middle.
std::string room_under_overcast_sky(const std::string& open_wall) {
  return box_case({.size = "[4, 4, 3]",
                   .edge_length = 2,
                   .walls = open_wall + " = \"opening\"",
                   .bands = "names = [\"light\"]\nedges = [550, 560]"},
                  R"([walls."*"]
[[light]]
kind = "sky"
name = "overcast"
radiance = 1
distribution = "overcast.csv"
walls = ["opening"]
[[sensor]]
name = "near"
position = [0.5, 2, 0]
normal = [0, 0, 1]
daylight_factor = true
[[sensor]]
name = "middle"
position = [2, 2, 0]
normal = [0, 0, 1]
daylight_factor = true
[[sensor]]
name = "far"
position = [3.5, 2, 0]
normal = [0, 0, 1]
daylight_factor = true
)");
}

/// Sky component in percent: the integral over the opening of L cos cos'/r^2 over 7 pi/9, by the midpoint
/// rule; `at` gives the vector from the point to (u, v) of the opening, from 0 to 1, and `across` is its
/// normal.
double sky_component(const std::function<Vec3(double, double)>& at, const Vec3& across, double area) {
  double sum = 0;
  constexpr int steps = 300;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const Vec3 separation = at((i + 0.5) / steps, (j + 0.5) / steps);
      const double up = separation.normalized().z(), square = separation.squaredNorm();
      sum += (1 + 2 * up) / 3 * up * separation.normalized().dot(across) / square * area / (steps * steps);
    }
  return 100 * sum / (7 * pi / 9);
}

void expect_sky_components(const std::string& open_wall, const std::function<double(double)>& component) {
  const CaseFolder folder(room_under_overcast_sky(open_wall));
  std::ofstream table(folder.path() / "overcast.csv");
  for (int degrees = 0; degrees <= 90; degrees += 2)
    table << degrees << ", " << (1 + 2 * std::cos(degrees * pi / 180)) / 3 << "\n";
  table.close();
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  for (const auto& [name, x] : {std::pair<std::string, double>{"near", 0.5}, {"middle", 2}, {"far", 3.5}})
    EXPECT_NEAR(rows[name + " light daylight_factor %"].at(2) / component(x), 1, 0.02)
        << open_wall << " " << name << " " << component(x);
}

// 5.9, sky component under an unglazed opening in the roof.
TEST(Cie171, SkyComponentUnderARoofOpening) {
  expect_sky_components("zmax", [](double x) {
    return sky_component([x](double u, double v) { return Vec3(4 * u - x, 4 * v - 2, 3); }, Vec3::UnitZ(),
                         16);
  });
}

// 5.11, sky component beside an unglazed opening in the facade, without obstacles or ground outside.
TEST(Cie171, SkyComponentBesideAFacadeOpening) {
  expect_sky_components("xmin", [](double x) {
    return sky_component([x](double u, double v) { return Vec3(-x, 4 * u - 2, 3 * v); }, -Vec3::UnitX(), 12);
  });
}

}  // namespace
}  // namespace etendue::cie171_test
