// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/readings/probes.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "tests/app/write/sample_run.h"

namespace etendue::probes_test {
namespace {

using test::SampleRun;

TEST(Probes, OutsideTheMeshAreNamedAllAtOnce) {
  const SampleRun run({"grey"});
  const CellLocator locator(run.mesh);
  const std::vector<Probe> probes = {
      {"far", {Vec3(5, 5, 5)}, {}, {"room.toml", 9, "probe.points"}},
      {"line", {Vec3(0.5, 0.5, 0.5), Vec3(0.5, 0.5, 1.5)}, Vec3::UnitZ(), {"room.toml", 7, "probe.line"}}};
  try {
    place_probes(probes, run.mesh, locator);
    FAIL() << "no fault";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "room.toml:7: probe.line = [0.5, 0.5, 1.5]: the point of probe \"line\" lies outside the mesh "
        "(which reaches from [0, 0, 0] to [1, 1, 1]); move it into a region\n"
        "room.toml:9: probe.points = [5, 5, 5]: the point of probe \"far\" lies outside the mesh "
        "(which reaches from [0, 0, 0] to [1, 1, 1]); move it into a region");
  }
}

TEST(Probes, WithANormalGetAMeterForEachPoint) {
  SampleRun run({"red", "green"});
  const CellLocator locator(run.mesh);
  const std::vector<Probe> probes = {{"plain", {Vec3(0.5, 0.25, 0.1)}, {}, {}},
                                     {"met", {Vec3(0.5, 0.5, 0.25), Vec3(0.1, 0.2, 0.3)}, Vec3::UnitX(), {}}};
  const std::vector<IrradianceMeter> meters = place_probes(probes, run.mesh, locator);
  ASSERT_EQ(meters.size(), 2U);
  EXPECT_EQ(meters[1].normal, Vec3::UnitX());
  EXPECT_FALSE(meters[1].cells.empty());

  run.solution.meters = {1, 2, 3, 4};
  const std::vector<ProbeRow> rows = read_probes(probes, LightSetup(run.problem), run.solution, locator, 1);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_FALSE(rows[0].irradiance);
  EXPECT_EQ(rows[0].values.size(), 2U);
  EXPECT_EQ(rows[1].irradiance, (std::vector<double>{1, 2}));
  EXPECT_EQ(rows[2].irradiance, (std::vector<double>{3, 4}));
  EXPECT_EQ(rows[2].index, 1);
}

}  // namespace
}  // namespace etendue::probes_test
