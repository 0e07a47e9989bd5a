// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The cases of `etendue new` as they are.
#include <gtest/gtest.h>

#include "app/cli/starters.h"
#include "tests/app/run/small_case.h"

namespace etendue::test {
namespace {

// The first run of a new user: no warning and no caution.
TEST(NewCase, EndsWithoutWarningAsItIs) {
  ASSERT_EQ(starters().size(), 4U);
  for (const Starter& starter : starters()) {
    const CaseFolder folder{std::string(starter.text)};
    const Outcome run = etendue_says({"run", folder.file(), "--no-estimate"});
    EXPECT_EQ(run.code, ExitCode::done) << starter.name << run.err;
    EXPECT_FALSE(has(run.out, "WARNING")) << starter.name << run.out;
    EXPECT_FALSE(has(run.out, "caution")) << starter.name << run.out;
  }
}

TEST(NewCase, OfAShieldIsSureToFivePercent) {
  for (const Starter& starter : starters()) {
    if (std::string(starter.name) != "shield") continue;
    const CaseFolder folder{std::string(starter.text)};
    const Outcome run = etendue_says({"run", folder.file(), "--estimate"});
    ASSERT_EQ(run.code, ExitCode::done) << run.err;
    const std::size_t at = run.out.find(": about ", run.out.find("the least sure is"));
    ASSERT_NE(at, std::string::npos) << run.out;
    EXPECT_LT(std::stod(run.out.substr(at + std::string(": about ").size())), 5) << run.out;
  }
}

}  // namespace
}  // namespace etendue::test
