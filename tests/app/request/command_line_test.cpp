// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/request/command_line.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace etendue::command_line_test {
namespace {

template <class Wanted>
Wanted parsed(const std::vector<std::string>& arguments) {
  return std::get<Wanted>(parse_command_line(arguments));
}

std::string fault_of(const std::vector<std::string>& arguments) {
  try {
    parse_command_line(arguments);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CommandLine, TakesEachOverrideAsOneArgument) {
  const auto run = parsed<RunRequest>({"run", "--set", "a=1", "--set", "b=[1, 2]", "case.toml"});
  EXPECT_EQ(run.file, "case.toml");
  EXPECT_EQ(run.overrides, (Overrides{"a=1", "b=[1, 2]"}));
}

TEST(CommandLine, TurnsOutputAndThreadsIntoOverrides) {
  const auto run = parsed<RunRequest>({"run", "case.toml", "--output", "/tmp/a \"b\"", "--threads", "3"});
  EXPECT_EQ(run.overrides, (Overrides{R"(output.directory="/tmp/a \"b\"")", "solve.threads=3"}));
}

TEST(CommandLine, TakesTheOutputRelativeToTheWorkingDirectory) {
  const auto run = parsed<RunRequest>({"run", "cases/case.toml", "--output", "out"});
  const std::string path = (std::filesystem::current_path() / "out").string();
  EXPECT_EQ(run.overrides, Overrides{"output.directory=\"" + path + "\""});
}

TEST(CommandLine, KnowsTheStylesOfProgress) {
  EXPECT_EQ(parsed<RunRequest>({"run", "c"}).progress, ProgressStyle::automatic);
  EXPECT_EQ(parsed<RunRequest>({"run", "c", "--progress", "none"}).progress, ProgressStyle::none);
  EXPECT_EQ(parsed<RunRequest>({"run", "c", "--progress", "bar"}).progress, ProgressStyle::bar);
  EXPECT_NE(fault_of({"run", "c", "--progress", "disco"}).find("disco"), std::string::npos);
}

TEST(CommandLine, ReadsTheOtherCommands) {
  EXPECT_TRUE(parsed<CheckRequest>({"check", "c", "--mesh"}).mesh);
  EXPECT_EQ(parsed<MeshRequest>({"mesh", "c", "-o", "m.vtu"}).output, "m.vtu");
  EXPECT_EQ(parsed<DirectionsRequest>({"directions", "--set", "product", "--order", "4"}).order, 4);
  EXPECT_FALSE(parsed<DirectionsRequest>({"directions"}).set);
  EXPECT_EQ(parsed<KeysRequest>({"keys"}).path, "");
  EXPECT_EQ(parsed<KeysRequest>({"keys", "mesh.box"}).path, "mesh.box");
}

TEST(CommandLine, ShowsHelpWithExamplesAndTheVersion) {
  EXPECT_NE(parsed<ShowText>({"--help"}).text.find("etendue run cases/"), std::string::npos);
  EXPECT_NE(parsed<ShowText>({"run", "--help"}).text.find("--threads"), std::string::npos);
  EXPECT_EQ(parsed<ShowText>({"--version"}).text.rfind("etendue 0.", 0), 0U);
}

TEST(CommandLine, ShowsTheExamplesOfTheCommandAlone) {
  const std::string mesh = parsed<ShowText>({"mesh", "--help"}).text;
  EXPECT_NE(mesh.find("etendue mesh case.toml -o mesh.vtu"), std::string::npos);
  EXPECT_EQ(mesh.find("etendue study"), std::string::npos);
  for (const char* command : {"run", "render", "bake", "study", "compare", "check", "directions", "keys"})
    EXPECT_NE(parsed<ShowText>({command, "--help"}).text.find(std::string("  etendue ") + command + " "),
              std::string::npos)
        << command;
}

TEST(CommandLine, NamesTheCommandOrTheOptionThatIsMeant) {
  EXPECT_NE(fault_of({"rnu", "c"}).find("did you mean \"run\"?"), std::string::npos);
  EXPECT_NE(fault_of({"run", "c", "--treads", "2"}).find("did you mean \"--threads\"?"), std::string::npos);
  EXPECT_NE(fault_of({"run", "c", "--ouput=x"}).find("did you mean \"--output\"?"), std::string::npos);
  EXPECT_EQ(fault_of({"run", "c", "--zzzzzz"}).find("did you mean"), std::string::npos);
}

TEST(CommandLine, SaysInOneLineWhatIsWrong) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"dance"},
                                                    {"run"},
                                                    {"run", "c", "--frames", "3"},
                                                    {"run", "c", "--threads", "-1"},
                                                    {"run", "c", "--threads", "two"},
                                                    {"mesh", "c"},
                                                    {"directions", "--set", "product"}}) {
    const std::string fault = fault_of(arguments);
    EXPECT_EQ(fault.rfind("command line: ", 0), 0U) << fault;
    EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
    EXPECT_NE(fault.find("--help"), std::string::npos) << fault;
  }
}

TEST(CommandLine, ReadsWhatToCompare) {
  const auto compare = parsed<CompareRequest>(
      {"compare", "case.toml", "--methods", "ordinates,photons", "--output", "out", "--threads", "2"});
  EXPECT_EQ(compare.methods, (std::vector<std::string>{"ordinates", "photons"}));
  EXPECT_EQ(compare.run.file, "case.toml");
  EXPECT_EQ(compare.run.overrides.size(), 2U);
  EXPECT_NE(fault_of({"compare", "case.toml", "--methods", "photons,photons"}).find("the same method twice"),
            std::string::npos);
  EXPECT_NE(fault_of({"compare", "case.toml", "--methods", "photons,magic"}).find("magic"),
            std::string::npos);
}

TEST(CommandLine, TakesAStudyAgainstALimitOnlyWithThreeLevelsOfOneSize) {
  const auto study = parsed<StudyRequest>(
      {"study", "c.toml", "--refine", "mesh", "--levels", "3", "--against", "richardson"});
  EXPECT_EQ(study.against, StudyReference::richardson);
  EXPECT_EQ(parsed<StudyRequest>({"study", "c.toml", "--refine", "mesh", "--levels", "3"}).against,
            StudyReference::finest);
  EXPECT_NE(fault_of({"study", "c", "--refine", "mesh", "--levels", "2", "--against", "richardson"})
                .find("too few for --against richardson"),
            std::string::npos);
  EXPECT_NE(fault_of({"study", "c", "--refine", "both", "--levels", "3", "--against", "richardson"})
                .find("refine the mesh or the directions"),
            std::string::npos);
}

TEST(CommandLine, ReadsWhatToRender) {
  const auto plain = parsed<RenderRequest>({"render", "results"});
  EXPECT_EQ(plain.results, "results");
  EXPECT_TRUE(plain.cameras.empty() && plain.file.empty() && !plain.output && !plain.threads);
  const auto full =
      parsed<RenderRequest>({"render", "results", "--camera", "a", "--camera", "b", "--case", "c.toml",
                             "--output", "out", "--threads", "2", "--set", "x=1", "--progress", "plain"});
  EXPECT_EQ(full.cameras, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(full.file, "c.toml");
  EXPECT_EQ(full.output, "out");
  EXPECT_EQ(full.threads, 2);
  EXPECT_EQ(full.overrides, Overrides{"x=1"});
  EXPECT_EQ(full.progress, ProgressStyle::plain);
}

}  // namespace
}  // namespace etendue::command_line_test
