// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/solution_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/write/results.h"
#include "base/errors.h"
#include "tests/app/write/sample_run.h"

namespace etendue::solution_file_test {
namespace {

using test::SampleRun;
using test::ScratchFolder;

/// Numbers that need all their digits.
std::vector<double> thirds(std::size_t count, double first) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back((first + static_cast<double>(i)) / 3);
  return values;
}

SavedState sample_state(const TetrahedralMesh& mesh, std::size_t bands) {
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  const auto faces = static_cast<std::size_t>(mesh.boundary_face_count());
  return {static_cast<int>(bands),       thirds(cells * 4 * bands, 1), thirds(2 * 4 * 4 * bands, 1e-300),
          thirds(faces * 3 * bands, -7), thirds(2 * 3 * bands, 1e200), {},
          thirds(2 * 4 * bands, 0.7)};
}

const std::string sample_toml = R"(title = "Sample"

[units]
length = "m"
illuminance = "lx"

[mesh]
max_volume = 1.0

[media.low]
absorption = 1.0

[media.high]
absorption = 2.0

[walls."*"]
diffuse = 0.5

[solve]
tolerance = 1e-06

[output]
directory = "results"
)";

class SolutionFile : public testing::Test {
 protected:
  SolutionFile() {
    run.input.resolved_toml = sample_toml;
    run.input.output.directory = folder.path();
    state = sample_state(run.mesh, 3);
    write_checkpoint(run.input, run.problem, state);
  }

  void change(const std::string& from, const std::string& to) {
    std::string& text = run.input.resolved_toml;
    text.replace(text.find(from), from.size(), to);
  }

  std::filesystem::path file() const { return folder.path() / "solution.vtu"; }
  SavedState read() const {
    return read_initial({file(), {"case.toml", 8, "solve.initial"}}, run.input, run.mesh);
  }

  std::string refusal() const {
    try {
      read();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  ScratchFolder folder;
  SampleRun run{{"red", "green", "blue"}};
  SavedState state;
};

TEST_F(SolutionFile, GivesTheStateBackToTheLastBit) {
  const SavedState again = read();
  EXPECT_EQ(again.bands, 3);
  EXPECT_EQ(again.fluence, state.fluence);
  EXPECT_EQ(again.moments, state.moments);
  EXPECT_EQ(again.irradiance, state.irradiance);
  EXPECT_EQ(again.mirrors, state.mirrors);
  EXPECT_EQ(again.lagged, state.lagged);
  EXPECT_EQ(again.radiance, state.radiance);
}

TEST_F(SolutionFile, GivesTheStateBackFromAppendedDataToo) {
  run.input.output.encoding = VtkEncoding::appended_raw;
  write_checkpoint(run.input, run.problem, state);
  EXPECT_NE(test::text_of(file()).find("<AppendedData"), std::string::npos);
  const SavedState again = read();
  EXPECT_EQ(again.fluence, state.fluence);
  EXPECT_EQ(again.moments, state.moments);
}

TEST_F(SolutionFile, IsTakenWhereOnlyTheWayToTheSolutionAndItsReportDiffer) {
  change("\"Sample\"", "\"Another name\"");
  change("1e-06", "1e-09");
  change("\"results\"", "\"elsewhere\"");
  change("\"lx\"", "\"fc\"\nluminous_exitance = \"lm/ft^2\"");
  run.input.resolved_toml += "\n[[probe]]\nname = \"new\"\n";
  EXPECT_EQ(refusal(), "");
}

TEST_F(SolutionFile, IsTakenWhereTablesStandInAnotherOrder) {
  change("[media.low]\nabsorption = 1.0\n\n[media.high]\nabsorption = 2.0\n",
         "[media.high]\nabsorption = 2.0\n\n[media.low]\nabsorption = 1.0\n");
  EXPECT_EQ(refusal(), "");
}

TEST_F(SolutionFile, OfAnotherCaseIsRefusedWithThePartsThatDiffer) {
  change("absorption = 2.0", "absorption = 3.0");
  change("[walls.\"*\"]", "[directions]\norder = 2\n\n[walls.\"*\"]");
  EXPECT_EQ(refusal(),
            "case.toml:8: solve.initial = \"" + file().string() +
                "\": is a solution of another case ([directions], [media] differ); only the title, "
                "[mesh] if it gives the same cells, space.positivity, photometric units, [solve], [[probe]], "
                "[[camera]], [[sensor]] and [output] may, so start without or undo that");
}

TEST_F(SolutionFile, OfAnotherMeshIsRefused) {
  RawMesh raw = test::cube_of_six();
  raw.points[7] *= 1.0625;
  const TetrahedralMesh other(raw);
  try {
    read_initial({file(), {"case.toml", 8, "solve.initial"}}, run.input, other);
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("is a solution on another mesh (of 6 cells; here are 6)"));
  }
}

TEST_F(SolutionFile, ThatIsDamagedOrNoneIsRefused) {
  const std::string whole = test::text_of(file());
  for (const std::string& text :
       {whole.substr(0, whole.size() / 2), whole.substr(0, 40), std::string("no\n")}) {
    test::write_text(file(), text);
    EXPECT_THROW(read(), FileError) << text.size();
  }
  std::filesystem::remove(file());
  EXPECT_THAT(refusal(), testing::HasSubstr("cannot be opened"));
}

TEST_F(SolutionFile, OfACheckpointReplacesEarlierResults) {
  write_results(run.result());
  ASSERT_TRUE(std::filesystem::exists(folder.path() / "summary.json"));
  test::write_text(folder.path() / "mine.txt", "kept");
  write_checkpoint(run.input, run.problem, state);
  EXPECT_EQ(ScratchFolder::names_in(folder.path()), (std::vector<std::string>{"mine.txt", "solution.vtu"}));
}

}  // namespace
}  // namespace etendue::solution_file_test
