// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>
#include <string_view>

#include "app/cli/starters.h"
#include "tests/app/run/small_case.h"

namespace etendue::test {
namespace {

// Coarsely, to be quick.
const std::map<std::string_view, Overrides> coarsely = {
    {"room", {"mesh.edge_length=1.5", "camera.0.pixels=[16, 12]"}},
    {"furnace", {"mesh.edge_length=1.5"}},
    {"tissue", {"mesh.edge_length=3", "solve.photons=200"}},
    {"shield", {"mesh.edge_length=30", "solve.photons=2000", "solve.probe_photons=200"}}};

TEST(NewCase, WritesCasesThatRun) {
  const CaseFolder folder;
  ASSERT_EQ(starters().size(), coarsely.size());
  for (const Starter& starter : starters()) {
    const std::string file = (folder.path() / (std::string(starter.name) + "_new.toml")).string();
    const Outcome written = etendue_says({"new", std::string(starter.name), "-o", file});
    ASSERT_EQ(written.code, ExitCode::done) << written.err;
    EXPECT_EQ(text_of(file), starter.text);
    std::vector<std::string> run = {"run", file, "--output", (folder.path() / "out").string()};
    for (const std::string& change : coarsely.at(starter.name)) run.insert(run.end(), {"--set", change});
    const Outcome outcome = etendue_says(run);
    EXPECT_EQ(outcome.code, ExitCode::done) << starter.name << outcome.err;
  }
}

TEST(NewCase, ReplacesNoFileAndNamesTheKinds) {
  const CaseFolder folder;
  const Outcome again = etendue_says({"new", "room", "-o", folder.file()});
  EXPECT_EQ(again.code, ExitCode::input_error);
  EXPECT_TRUE(has(again.err, "is there already")) << again.err;
  const Outcome unknown = etendue_says({"new", "rom"});
  EXPECT_EQ(unknown.code, ExitCode::input_error);
  EXPECT_TRUE(has(unknown.err, "did you mean \"room\"?")) << unknown.err;
  EXPECT_TRUE(has(unknown.err, "room, furnace, tissue or shield")) << unknown.err;
  const Outcome nowhere = etendue_says({"new", "room", "-o", (folder.path() / "no" / "such.toml").string()});
  EXPECT_EQ(nowhere.code, ExitCode::file_error) << nowhere.err;
}

}  // namespace
}  // namespace etendue::test
