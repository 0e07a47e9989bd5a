// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/run_log.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/app/run/small_case.h"

namespace etendue::run_log_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::Outcome;
using test::ScratchFolder;
using test::text_of;
using test::write_text;

/// What log.txt holds after its heading of two lines.
std::string logged_in(const std::filesystem::path& directory, const std::string& name = "log.txt") {
  const std::string text = text_of(directory / name);
  return text.substr(text.find('\n', text.find('\n') + 1) + 1);
}

TEST(RunLog, HoldsWhatTheRunPrinted) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_EQ(logged_in(folder.results()), outcome.out);
}

TEST(RunLog, BeginsWithVersionDateMachineAndCommand) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says({"run", folder.file(), "--set", "title='two words'"}).code, ExitCode::done);
  const std::string text = text_of(std::filesystem::path(folder.results()) / "log.txt");
  const std::regex heading(
      "etendue [0-9.]+ \\(commit [0-9a-z-]+\\), [0-9-]{10}T[0-9:]{8}Z, on .+\n"
      "command: etendue run .*case\\.toml --set 'title='\\\\''two words'\\\\''' --no-estimate\n");
  EXPECT_TRUE(std::regex_search(text, heading, std::regex_constants::match_continuous)) << text;
}

TEST(RunLog, HoldsTheWarningsOfARunThatDidNotConverge) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "solve.max_sweeps=2"});
  ASSERT_EQ(outcome.code, ExitCode::not_converged);
  EXPECT_EQ(logged_in(folder.results()), outcome.out + outcome.err);
}

TEST(RunLog, IsNamedInTheSummaryAndReplacedByTheNextRun) {
  const CaseFolder folder;
  for (int run = 0; run < 2; ++run) ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const auto summary =
      nlohmann::json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
  EXPECT_EQ(std::ranges::count(summary["files"], "log.txt"), 1);
}

TEST(RunLog, DoesNotJoinTheResultsOfAnotherRun) {
  const CaseFolder folder;
  const std::filesystem::path results = folder.results();
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  test::make_of_another_process(results);
  const std::string before = text_of(results / "log.txt");
  RunLog log({});
  log.add("of this run\n");
  log.belongs_in(results);
  log.save();
  append_to_log(results, "and its estimate");
  EXPECT_EQ(text_of(results / "log.txt"), before);
}

TEST(RunLog, OfAFailedRunEndsWithTheFaultAndLeavesTheLogOfTheResults) {
  const CaseFolder folder;
  const std::filesystem::path results = folder.results();
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const std::string before = text_of(results / "log.txt");
  std::filesystem::remove(results / "walls.vtp");
  std::filesystem::create_directory(results / "walls.vtp");
  const Outcome failed = etendue_says({"run", folder.file()});
  ASSERT_EQ(failed.code, ExitCode::file_error) << failed.err;
  EXPECT_EQ(logged_in(results, "log-failed.txt"), failed.out + failed.err);
  EXPECT_EQ(text_of(results / "log.txt"), before);
  std::filesystem::remove(results / "walls.vtp");
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  EXPECT_FALSE(std::filesystem::exists(results / "log-failed.txt")) << "the next good run removes it";
}

TEST(RunLog, OfARunThatIsRefusedIsNotWritten) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "mesh={file='missing.msh'}"});
  ASSERT_EQ(outcome.code, ExitCode::file_error) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder.results()));
}

TEST(LoggedStream, KeepsLinesWithoutDrawings) {
  std::ostringstream shown;
  RunLog log({});
  const ScratchFolder folder;
  log.belongs_in(folder.path());
  const std::string drawn =
      "mesh\n\r  [##..]  sweep 1\x1b[K\r  [####]  sweep 2\x1b[K\n\r  probes: 50 %\x1b[K\r\x1b[Kdone\n\nend";
  {
    LoggedStream stream(shown, log);
    stream << drawn << std::flush;
  }
  log.save();
  EXPECT_EQ(shown.str(), drawn);
  const std::string text = text_of(folder.path() / "log.txt");
  EXPECT_EQ(text.substr(text.find('\n') + 1), "mesh\ndone\n\nend\n");
}

TEST(LoggedStream, KeepsWhatAClosedStreamDoesNotShow) {
  std::ostringstream shown;
  shown.setstate(std::ios::badbit);
  RunLog log({});
  const ScratchFolder folder;
  log.belongs_in(folder.path());
  {
    LoggedStream stream(shown, log);
    stream << "one\n" << std::flush << "two\n";
  }
  log.save();
  const std::string text = text_of(folder.path() / "log.txt");
  EXPECT_EQ(text.substr(text.find('\n') + 1), "one\ntwo\n");
}

}  // namespace
}  // namespace etendue::run_log_test
