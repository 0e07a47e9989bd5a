// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/command.h"
#include "app/setup/memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/gibibyte.h"
#include "tests/app/run/small_case.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::command_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;

TEST(Command, HelpAndVersionGoToStandardOutput) {
  const Outcome help = etendue_says({"--help"});
  EXPECT_EQ(help.code, ExitCode::done);
  EXPECT_TRUE(has(help.out, "Examples:"));
  EXPECT_EQ(help.err, "");
  EXPECT_EQ(etendue_says({"--version"}).code, ExitCode::done);
}

TEST(Command, WrongArgumentsAreInputErrors) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"dance"},
                                                    {"study", "case.toml"},
                                                    {"directions", "--set", "product", "--order", "3"},
                                                    {"directions", "--set", "square", "--order", "2"}}) {
    const Outcome outcome = etendue_says(arguments);
    EXPECT_EQ(outcome.code, ExitCode::input_error);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(Command, ACaseThatIsNotThereIsAFileError) {
  for (const char* command : {"run", "check"}) {
    const Outcome outcome = etendue_says({command, "/nowhere/case.toml"});
    EXPECT_EQ(outcome.code, ExitCode::file_error);
    EXPECT_TRUE(has(outcome.err, "/nowhere/case.toml")) << outcome.err;
  }
}

TEST(Command, AFaultyCaseIsAnInputErrorWithFileAndLine) {
  const CaseFolder folder(test::small_case() + "[solve]\ntolerance = -1\n");
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "case.toml:28: solve.tolerance = -1")) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder.results()));
}

TEST(Command, ARunThatLosesLightIsMarkedAndEndsWithOne) {
  const CaseFolder sound, lossy(test::small_case() + "[solve]\nbalance_tolerance = 1e-30\n");
  EXPECT_EQ(etendue_says({"run", sound.file()}).code, ExitCode::done);
  EXPECT_TRUE(has(test::text_of(sound.path() / "results/summary.json"), "\"balanced\": true"));
  const Outcome outcome = etendue_says({"run", lossy.file()});
  EXPECT_EQ(outcome.code, ExitCode::not_converged);
  for (const std::string& text : {outcome.out, outcome.err})
    EXPECT_TRUE(has(text, "WARNING: NOT BALANCED") && has(text, "in band red")) << text;
  const std::string summary = test::text_of(lossy.path() / "results/summary.json");
  EXPECT_TRUE(has(summary, "\"balanced\": false") && has(summary, "\"converged\": true")) << summary;
}

TEST(Command, CheckDescribesACaseAndMakesNothing) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"check", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "product 2: 8")) << outcome.out;
  EXPECT_EQ(ScratchFolder::names_in(folder.path()), std::vector<std::string>{"case.toml"});
}

/// A message up to the place in the mesh that it names: meshes differ.
std::string without_place(const std::string& message) { return message.substr(0, message.find(" at (")); }

/// The fault that `check` and `run` both find in a case.
std::string fault_of(const std::string& text) {
  const CaseFolder folder(text);
  const Outcome checked = etendue_says({"check", folder.file()});
  EXPECT_EQ(checked.out, "");
  const Outcome run = etendue_says({"run", folder.file()});
  EXPECT_EQ(checked.code, run.code);
  EXPECT_EQ(without_place(checked.err), without_place(run.err));
  return checked.err;
}

TEST(Command, CheckRefusesMeshFilesThatARunCannotRead) {
  const std::string rest = R"(
[media."*"]
absorption = 1
[walls."*"]
diffuse = 0.5
)";
  EXPECT_TRUE(has(fault_of("[mesh]\nfile = \"part.step\"\n" + rest), "is not the name of a mesh file"));
  EXPECT_TRUE(
      has(fault_of("[mesh]\nfile = \"missing.msh\"\n" + rest), "case.toml:2: mesh.file = \"missing.msh\""));
  EXPECT_TRUE(has(fault_of("[mesh]\nsurface = \"missing.stl\"\n" + rest), "case.toml:2: mesh.surface = "));
  EXPECT_TRUE(has(fault_of("[mesh]\nlabels = { file = \"missing.vti\", regions = { a = 1 } }\n" + rest),
                  "case.toml:2: mesh.labels.file = "));
  EXPECT_TRUE(
      has(fault_of(test::small_case() + "[[light]]\nname = \"lamp\"\nkind = \"point\"\nposition = "
                                        "[0.5, 0.5, 0.5]\npower = 1\ndistribution = \"missing.ies\"\n"),
          "case.toml:32: light[0].distribution = "));
  // What else is wrong comes in the same round.
  const std::string both = fault_of("[mesh]\nfile = \"missing.msh\"\n[media.a]\n");
  EXPECT_TRUE(has(both, "missing.msh") && has(both, "as [walls.\"*\"]")) << both;
}

TEST(Command, CheckRefusesWhatOnlyTheProblemOfARunShows) {
  const std::string lamp = "[[light]]\nname = \"lamp\"\nkind = \"point\"\npower = 1\nposition = ";
  const std::string room = test::small_case();
  EXPECT_TRUE(has(fault_of(room + "[walls.zmax]\nrefractive_index = 1.5\n" + lamp + "[0.5, 0.5, 0.5]\n"),
                  "the wall zmax, which refracts, from within"));
  const std::string all = fault_of(room +
                                   "[walls.xmin]\nrefractive_index = 1.5\n[walls.xmax]\n"
                                   "refractive_index = 1.5\n" +
                                   lamp + "[0.5, 0.5, 0.5]\n");
  EXPECT_TRUE(has(all, "the walls xmin, xmax, which refract, from within")) << all;
  EXPECT_EQ(std::ranges::count(all, '\n'), 1) << all;
  EXPECT_TRUE(has(fault_of(room + lamp + "[2, 0, 0]\n"), "reaches out of the mesh"));
  EXPECT_TRUE(has(fault_of(room + "[[probe]]\nname = \"out\"\npoints = [[2, 0, 0]]\n"), "lies outside"));
  EXPECT_TRUE(has(fault_of(room + "[media.smok]\nabsorption = 1\n"), "smok"));
  EXPECT_TRUE(has(fault_of(room + "[[sensor]]\nname = \"s\"\nkind = \"flux\"\nwall = \"roof\"\n"), "roof"));
}

// A mirror that takes ordinates out of the set: only the solver knows.
TEST(Command, CheckRefusesMirrorsThatTheDirectionsDoNotAllow) {
  std::string text = test::small_case();
  text.replace(text.find("order = 2"), 9, "order = 2\nrotation = \"random\"");
  EXPECT_TRUE(has(fault_of(text + "[walls.zmax]\nspecular = 0.5\n"), "a mirrored ordinate must be in it"));
}

TEST(Command, CheckWithMeshReportsVolumesAndAreas) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"check", folder.file(), "--mesh"});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "smoke")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "floor")) << outcome.out;
}

/// GiB behind `bound` in the line "memory: about 0.1 GiB, at most 0.12 GiB"; -1 without one.
double memory_told(const Outcome& outcome, const std::string& bound) {
  const auto line = outcome.out.find("memory: ");
  const auto found = line == std::string::npos ? line : outcome.out.find(bound + " ", line);
  if (found == std::string::npos || found > outcome.out.find('\n', line)) return -1;
  return std::stod(outcome.out.substr(found + bound.size() + 1));
}

/// Memory that a run of the program says it will take over what it took, at a bound of the cells' volume.
double told_over_taken(const std::string& volume, const std::string& options, const std::string& bound) {
  const CaseFolder folder;
  const std::string said = (folder.path() / "said").string();
  const std::string command = ETENDUE_PROGRAM " run " + folder.file() +
                              " --no-estimate --set mesh.max_volume=" + volume + " " + options + " >" + said;
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  const double told = memory_told({ExitCode::done, test::text_of(said), ""}, bound) * gibibyte;
  const std::string summary = test::text_of(folder.results() + "/summary.json"), key = "\"peak_memory\": ";
  const std::size_t at = summary.find(key);
  if (at == std::string::npos) ADD_FAILURE() << summary;
  return at == std::string::npos ? 0 : told / std::stod(summary.substr(at + key.size()));
}

TEST(Command, CheckWithMeshCautionsAsARunDoes) {
  const CaseFolder folder;
  const std::vector<std::string> thick = {"--set", "media.smoke.absorption=30", "--set",
                                          "media.smoke.phase={ model = \"henyey-greenstein\", g = 0.9 }"};
  std::vector<std::string> check = {"check", folder.file(), "--mesh"}, run = {"run", folder.file()};
  check.insert(check.end(), thick.begin(), thick.end());
  run.insert(run.end(), thick.begin(), thick.end());
  const std::string checked = etendue_says(check).out, done = etendue_says(run).out;
  for (const char* what : {"scattering in smoke, bands red, green, blue: ", "cells: ", "mass lumped in ",
                           "caution: cells at lights", "caution: directions are"}) {
    EXPECT_TRUE(has(checked, what)) << checked;
    EXPECT_LT(done.find(what), done.find("iteration (")) << what << done;
  }
}

TEST(Command, CheckTellsTheMemoryThatARunTakes) {
  const CaseFolder folder;
  const auto words = [&](const std::string& command, const std::string& volume) {
    return std::vector<std::string>{command, folder.file(), "--set", "mesh.max_volume=" + volume};
  };
  for (const std::string volume : {"1e-3", "1e-4"}) {
    const double run = memory_told(etendue_says(words("run", volume)), "at most");
    std::vector<std::string> with_mesh = words("check", volume);
    with_mesh.emplace_back("--mesh");
    EXPECT_EQ(memory_told(etendue_says(with_mesh), "at most"), run) << volume;
    const double expected = memory_told(etendue_says(words("check", volume)), "about");
    EXPECT_GT(expected, run / 1.5) << volume;
    EXPECT_LT(expected, run * 1.5) << volume;
  }
}

TEST(Command, CheckRefusesWhatTheMachineCannotHoldAsRunDoes) {
  const CaseFolder folder;
  const Outcome refused = etendue_says({"check", folder.file(), "--set", "mesh.max_volume=1e-13"});
  EXPECT_EQ(refused.code, ExitCode::input_error);
  EXPECT_TRUE(has(refused.err, "mesh: about 2e+13 cells and 3 bands with these directions")) << refused.err;
  EXPECT_TRUE(has(refused.err, "and this machine has")) << refused.err;
}

TEST(Command, CheckWithMeshFindsProbesOutside) {
  const CaseFolder outside(test::small_case() + "[[probe]]\nname = \"out\"\npoints = [[2, 0, 0]]\n");
  const Outcome refused = etendue_says({"check", outside.file(), "--mesh"});
  EXPECT_EQ(refused.code, ExitCode::input_error);
  EXPECT_TRUE(has(refused.err, "[2, 0, 0]: the point of probe \"out\" lies outside")) << refused.err;
}

TEST(Command, MeshWritesTetrahedra) {
  const CaseFolder folder;
  const std::string mesh = (folder.path() / "deep" / "mesh.vtu").string();
  const Outcome outcome = etendue_says({"mesh", folder.file(), "-o", mesh});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_GT(std::filesystem::file_size(mesh), 1000U);
  EXPECT_TRUE(has(outcome.out, mesh));
}

TEST(Command, RunsWithClosedStandardStreams) {
  for (const char* closed : {"<&-", ">&-", "2>&-", "<&- >&- 2>&-"}) {
    const CaseFolder folder;
    const std::string mesh = (folder.path() / "mesh.vtu").string();
    const std::string command = ETENDUE_PROGRAM " mesh " + folder.file() + " -o " + mesh + " >/dev/null ";
    EXPECT_EQ(std::system((command + closed).c_str()), 0) << closed;
    EXPECT_GT(std::filesystem::file_size(mesh), 1000U) << closed;
  }
}

TEST(Command, MeshRefusesOtherKindsOfFiles) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"mesh", folder.file(), "-o", "mesh.stl"});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "ends in .vtu")) << outcome.err;
}

TEST(Command, CheckListsThePhaseFunctionsByAngle) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says(
      {"check", folder.file(), "--phase", "--set", "media.smoke.phase={model='henyey-greenstein',g=0.5}"});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("medium,band,degrees,p\nsmoke,red,0,", 0), 0u) << outcome.out.substr(0, 80);
  // (1 - g^2)/(4 pi (1 + g)^3) straight back.
  EXPECT_TRUE(has(outcome.out, "\nsmoke,blue,180,0.0176838")) << outcome.out.substr(outcome.out.size() - 80);
}

TEST(Command, CheckListsLeavesByTheDirectionThatTheyAreLitFrom) {
  const CaseFolder folder;
  const Outcome outcome =
      etendue_says({"check", folder.file(), "--phase", "--set",
                    "media.smoke={leaves={area_density=1,angles='horizontal',reflectance=0.5}}"});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  // Lambert's 1/pi straight back, where light comes from above.
  EXPECT_TRUE(has(outcome.out, "\nsmoke from (0 0 -1),red,180,0.318309886\n")) << outcome.out.substr(0, 300);
  EXPECT_FALSE(has(outcome.out, "from (1 0 0)")) << "level leaves are not seen from the side";
}

TEST(Command, DirectionsShowsAllSetsOrOneInFull) {
  const Outcome all = etendue_says({"directions"});
  EXPECT_EQ(all.code, ExitCode::done);
  for (const char* set : {"product", "triangular", "double-gauss", "ldfe-sq", "level-symmetric", "thurgood"})
    EXPECT_TRUE(has(all.out, set)) << set;
  const Outcome one = etendue_says({"directions", "--set", "product", "--order", "2"});
  EXPECT_TRUE(has(one.out, "ordinate,x,y,z,weight\n0,")) << one.out;
  EXPECT_TRUE(has(one.out, "\n7,"));
  for (const char* line :
       {"sum of w              12.566370614359", "sum of w Omega        ", "axis walls, x y z"})
    EXPECT_TRUE(has(one.out, line)) << one.out;
}

TEST(Command, DirectionsShowsTheSetOfACaseTurnedAndRefined) {
  std::string text = test::small_case();
  const std::string plain = "set = \"product\"\norder = 2\n";
  text.replace(text.find(plain), plain.size(), "refine = { direction = [0, 0, 1], angle = 5, levels = 1 }\n");
  const CaseFolder folder(text);
  const Outcome outcome = etendue_says({"directions", folder.file(), "-o", folder.path() / "set.vtp"});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "refined")) << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "set.vtp"));
}

TEST(Command, DirectionsAsksWhichSetToWrite) {
  const Outcome outcome = etendue_says({"directions", "-o", "set.vtp"});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "which set is meant")) << outcome.err;
}

TEST(Command, DirectionsWritesASetAsPoints) {
  const CaseFolder folder;
  const std::string file = folder.path() / "new" / "set.vtp";
  const Outcome outcome = etendue_says({"directions", "--set", "thurgood", "--order", "2", "-o", file});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(file));
  const Outcome other = etendue_says({"directions", "--set", "thurgood", "--order", "2", "-o", "set.vtu"});
  EXPECT_EQ(other.code, ExitCode::input_error);
  EXPECT_TRUE(has(other.err, "ends in .vtp")) << other.err;
}

TEST(Command, RunRefusesAxisMirrorsWithARotatedSet) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "walls.\"*\"={specular=0.5}", "--set",
                                        "directions.rotation=random", "--output", folder.results()});
  EXPECT_EQ(outcome.code, ExitCode::input_error) << outcome.out;
  EXPECT_TRUE(has(outcome.err, "out of the rotated ")) << outcome.err;
  const Outcome black = etendue_says(
      {"run", folder.file(), "--set", "directions.rotation=random", "--output", folder.results()});
  EXPECT_EQ(black.code, ExitCode::done) << black.err;
  EXPECT_TRUE(has(black.out, "(rotated ")) << black.out;
}

TEST(Command, KeysShowsTheReference) {
  const Outcome keys = etendue_says({"keys"});
  EXPECT_EQ(keys.code, ExitCode::done);
  EXPECT_TRUE(has(keys.out, "max_sweeps"));
}

TEST(Memory, OfAMatrixIsSaidBeforeTheRunAndRefusedWithTheFigureWhereThereIsNotAsMuch) {
  const CaseFolder folder;
  const std::vector<std::string> dense = {
      "run", folder.file(), "--output", folder.results(), "--set", "media.smoke.scattering_method=dense"};
  const Outcome small = etendue_says(dense);
  EXPECT_EQ(small.code, ExitCode::done) << small.err;
  const std::size_t said = small.out.find("\nmemory: about ");
  ASSERT_NE(said, std::string::npos) << small.out;
  EXPECT_TRUE(has(small.out, " (scattering by a matrix: 0.")) << small.out;
  EXPECT_TRUE(has(small.out, " MiB for each angular solution of smoke)")) << small.out;
  EXPECT_LT(said, small.out.find("iteration (")) << small.out;

  // 98,568 directions: a matrix of 72 GiB, in two forms, for each of three bands.
  std::vector<std::string> large = dense;
  large.insert(large.end(), {"--set", "directions.order=222", "--set",
                             "media.smoke.phase=[{model='henyey-greenstein',g=0.5},{model='rayleigh'},"
                             "{model='isotropic'}]"});
  const Outcome refused = etendue_says(large);
  EXPECT_EQ(refused.code, ExitCode::input_error) << refused.out;
  EXPECT_TRUE(has(refused.err, " GiB (scattering by a matrix: ")) << refused.err;
  EXPECT_TRUE(has(refused.err, "or scattering_method = \"moments\"")) << refused.err;
}

// As a process of its own, whose peak is that of the run.
TEST(Memory, OfARunByPhotonsIsAsForecast) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer takes memory of its own";
#endif
  for (const std::string volume : {"0.02", "1e-4"})
    EXPECT_NEAR(
        told_over_taken(volume, "--set 'solve.method=\"photons\"' --set solve.photons=100", "at most"), 1,
        0.2)
        << volume;
}

// The number of Krylov vectors is not known beforehand.
TEST(Memory, OfARunByOrdinatesIsAsForecast) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer takes memory of its own";
#endif
  for (const std::string options :
       {"", "--set 'solve.method=\"source-iteration\"'", "--set directions.order=2"}) {
    EXPECT_NEAR(told_over_taken("1e-4", options, "about"), 1, 0.2) << options;
    EXPECT_GT(told_over_taken("1e-4", options, "at most"), 1) << options;
  }
}

TEST(Memory, RefusesWhatTheMachineDoesNotHaveWithTheFigure) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  EXPECT_NO_THROW(check_memory(1000, mesh, 1));
  try {
    check_memory(std::size_t{1} << 60, mesh, 3);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("3 bands with these directions and phase functions may need 1.07e+09 GiB"),
              std::string::npos)
        << text;
  }
}

}  // namespace
}  // namespace etendue::command_test
